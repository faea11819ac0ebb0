#pragma once
/// @file
/// The Minkowski difference of two bodies, {b − a}: its point nearest to the origin is the distance
/// from a to b, and the bodies overlap if it holds the origin.
///
/// All places are relative to the centre of a, so that no digit is lost far away from the origin.

#include <array>
#include <limits>
#include <vector>

#include "tumble/collide/convex.hpp"

namespace tumble::collide::detail {

/// A corner of the difference.
struct Corner {
  Vec3 w;          ///< b − a [m]
  int on_a, on_b;  ///< the numbers of the points
  friend bool operator==(const Corner& p, const Corner& q) {
    return p.on_a == q.on_a && p.on_b == q.on_b;
  }
};

/// The difference of two bodies without their radii.
class Difference {
 public:
  Difference(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b)
      : a_(a), b_(b), R_a_(pose_a.R), R_b_(pose_b.R), offset_(pose_b.x - pose_a.x) {}

  /// The corner that is farthest against n: b nearest along n, a farthest.
  Corner nearest_along(const Vec3& n) const {
    const int on_a = a_.farthest(R_a_.transpose() * n);
    const int on_b = b_.farthest(R_b_.transpose() * -n);
    return {offset_ + (arm_b(on_b) - arm_a(on_a)), on_a, on_b};
  }

  /// The directions in the world of the edges of a and b, if both are boxes; else none.
  std::array<std::vector<Vec3>, 2> box_edges() const {
    std::array<std::vector<Vec3>, 2> edges{a_.box_edges(), b_.box_edges()};
    if (edges[0].empty() || edges[1].empty()) return {};
    for (Vec3& edge : edges[0]) edge = R_a_ * edge;
    for (Vec3& edge : edges[1]) edge = R_b_ * edge;
    return edges;
  }

  const Vec3& offset() const { return offset_; }
  /// The size of the numbers that places are made of [m].
  double scale() const { return a_.reach() + b_.reach() + offset_.norm(); }

  /// Points relative to the centre of their body, in world axes.
  Vec3 arm_a(int i) const { return R_a_ * a_.point(i); }
  Vec3 arm_b(int i) const { return R_b_ * b_.point(i); }

 private:
  const Convex &a_, &b_;
  Mat3 R_a_, R_b_;
  Vec3 offset_;
};

/// What rounding leaves unsure of a place [m].
inline double rounding_of(const Difference& difference) {
  return 64 * std::numeric_limits<double>::epsilon() * difference.scale();
}

/// One to four corners, and how much each counts.
struct Simplex {
  int size = 0;
  std::array<Corner, 4> corners{};
  std::array<double, 4> weights{};

  const Vec3& w(int i) const { return corners[static_cast<std::size_t>(i)].w; }
  double& weight(int i) { return weights[static_cast<std::size_t>(i)]; }
  double weight(int i) const { return weights[static_cast<std::size_t>(i)]; }
  void add(const Corner& corner, double by = 0) {
    corners[static_cast<std::size_t>(size)] = corner;
    weights[static_cast<std::size_t>(size++)] = by;
  }
  bool has(const Corner& corner) const {
    for (int i = 0; i < size; ++i)
      if (corners[static_cast<std::size_t>(i)] == corner) return true;
    return false;
  }
  /// Σ weight w
  Vec3 point() const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < size; ++i) sum += weight(i) * w(i);
    return sum;
  }
};

}  // namespace tumble::collide::detail
