#pragma once
/// @file
/// On which side of an edge does a vertical line pass? Exactly, and never "on it".
///
/// Seen from above, side = sign((q − p) × (r − p)) with r the line's (x, y). The sign is computed
/// in doubles when the rounding cannot have changed it, else exactly. When it is 0 the line is
/// moved by (ε, ε²), ε infinitely small: all triangles are asked about the same moved line, so that
/// a line through an edge or a vertex is counted exactly once.
///
/// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates", Discrete Comput. Geom. 18 (1997), §4.2 (the bound) and §2.4 (expansions);
/// Edelsbrunner & Mücke, "Simulation of simplicity", ACM Trans. Graphics 9 (1990) (the move).

#include <array>
#include <cmath>

#include "tumble/core/rounding.hpp"
#include "tumble/core/types.hpp"

namespace tumble::detail {

/// A sum of doubles without an error: parts that do not overlap, smallest first, none of them 0.
/// @tparam n how many may be added
template <std::size_t n>
class ExactSum {
 public:
  void add(double b) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double a = parts_[i], sum = a + b, part = sum - a;
      const double rest = (a - (sum - part)) + (b - part);  // the rounding error of a + b
      if (rest != 0) parts_[kept++] = rest;
      b = sum;
    }
    if (b != 0) parts_[kept++] = b;
    size_ = kept;
  }
  /// Adds x y, as long as it neither over- nor underflows.
  void add_product(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }
  /// −1, 0 or 1.
  int sign() const { return size_ == 0 ? 0 : parts_[size_ - 1] > 0 ? 1 : -1; }

 private:
  std::array<double, n> parts_{};
  std::size_t size_ = 0;
};

/// The exact sign (−1, 0, 1) of Σ x_i y_i over pairs, as long as no product over- or underflows.
template <std::size_t n>
int exact_sign_of_products(const std::array<std::array<double, 2>, n>& pairs) {
  ExactSum<2 * n> sum;
  for (const std::array<double, 2>& pair : pairs) sum.add_product(pair[0], pair[1]);
  return sum.sign();
}

/// The sign of (q − p) × (r − p), all in the plane: 1 when r is to the left of p → q, 0 when on it.
inline int orientation(double px, double py, double qx, double qy, double rx, double ry) {
  const double left = (qx - px) * (ry - py), right = (qy - py) * (rx - px);
  const double det = left - right;
  if (std::abs(det) > (3 + 16 * unit_roundoff) * unit_roundoff * (std::abs(left) + std::abs(right)))
    return det > 0 ? 1 : -1;
  using Pair = std::array<double, 2>;
  return exact_sign_of_products(std::array<Pair, 6>{Pair{px, qy}, Pair{-py, qx}, Pair{qx, ry},
                                                    Pair{-qy, rx}, Pair{rx, py}, Pair{-ry, px}});
}

/// On which side of p → q the vertical line through (x + ε, y + ε²) passes: 1 left, −1 right; 0
/// only for an edge that is vertical itself.
inline int side_of_edge(const Vec3& p, const Vec3& q, double x, double y) {
  const int side = orientation(p.x(), p.y(), q.x(), q.y(), x, y);
  if (side != 0) return side;
  // (q − p) × (ε, ε²) = ε² (qx − px) − ε (qy − py)
  if (p.y() != q.y()) return p.y() > q.y() ? 1 : -1;
  return (q.x() > p.x()) - (q.x() < p.x());
}

/// Twice the area of the triangle of an edge, both ends taken from the line, and the line; with
/// what its rounding may be.
struct EdgeArea {
  double area, rounding;

  EdgeArea(double px, double py, double qx, double qy) {
    const double left = px * qy, right = py * qx;
    area = left - right;
    rounding = (3 + 16 * unit_roundoff) * unit_roundoff * (std::abs(left) + std::abs(right));
  }
  bool is_left() const { return area > rounding; }
  bool is_right() const { return area < -rounding; }
};

/// Whether the vertical line through (x, y) meets the triangle: 1 when it is seen counter-clockwise
/// from above (the line leaves the body, going up), −1 when clockwise (it enters), 0 when not met.
inline int line_crossing(const Vec3& a, const Vec3& b, const Vec3& c, double x, double y) {
  const double ax = a.x() - x, ay = a.y() - y, bx = b.x() - x, by = b.y() - y;
  const double cx = c.x() - x, cy = c.y() - y;
  const EdgeArea ab(ax, ay, bx, by), bc(bx, by, cx, cy), ca(cx, cy, ax, ay);
  // No branch on each: which side it is cannot be predicted. Exactness is asked for when in doubt.
  const int left = ab.is_left() + bc.is_left() + ca.is_left();
  const int right = ab.is_right() + bc.is_right() + ca.is_right();
  if (left * right > 0) return 0;
  if (left + right == 3) return left > 0 ? 1 : -1;
  const int side = side_of_edge(a, b, x, y);
  if (side == 0 || side_of_edge(b, c, x, y) != side || side_of_edge(c, a, x, y) != side) return 0;
  return side;
}

/// Whether the three points lie on one line, exactly.
inline bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orientation(a.x(), a.y(), b.x(), b.y(), c.x(), c.y()) == 0 &&
         orientation(a.y(), a.z(), b.y(), b.z(), c.y(), c.z()) == 0 &&
         orientation(a.z(), a.x(), b.z(), b.x(), c.z(), c.x()) == 0;
}

}  // namespace tumble::detail
