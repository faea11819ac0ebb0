#pragma once

#include "tumble/mesh/triangles_meet.hpp"

#include <limits>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/integer_determinant.hpp"
#include "tumble/simd/pair.hpp"

namespace tumble::detail {

TUMBLE_BODY bool has_exact_difference(const Vec3& p, const Vec3& q) {
  for (int i = 0; i < 3; ++i)
    if (two_diff(p[i], q[i]).lo != 0) return false;
  return true;
}

TUMBLE_BODY int exact_side_of_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const bool exact =
      has_exact_difference(a, d) && has_exact_difference(b, d) && has_exact_difference(c, d);
  if (exact) {
    const Vec3 u = a - d, v = b - d, w = c - d;
    if (const auto sign = integer_sign_of_determinant<3>(
            {{{u.x(), v.x(), w.x()}, {u.y(), v.y(), w.y()}, {u.z(), v.z(), w.z()}}}))
      return *sign;
    ExactSum<24> sum;
    add_determinant(sum, 1, u, v, w);
    return sum.sign();
  }
  if (const auto sign = integer_sign_of_determinant<4>({{{a.x(), b.x(), c.x(), d.x()},
                                                         {a.y(), b.y(), c.y(), d.y()},
                                                         {a.z(), b.z(), c.z(), d.z()}}}))
    return *sign;
  ExactSum<96> sum;
  add_determinant(sum, 1, a, b, c);
  add_determinant(sum, -1, a, b, d);
  add_determinant(sum, 1, a, c, d);
  add_determinant(sum, -1, b, c, d);
  return sum.sign();
}

TUMBLE_BODY int side_of_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double bc = v.x() * w.y(), cb = w.x() * v.y(), ca = w.x() * u.y(), ac = u.x() * w.y(),
               ab = u.x() * v.y(), ba = v.x() * u.y();
  const double det = u.z() * (bc - cb) + v.z() * (ca - ac) + w.z() * (ab - ba);
  const double size = std::abs(u.z()) * (std::abs(bc) + std::abs(cb)) +
                      std::abs(v.z()) * (std::abs(ca) + std::abs(ac)) +
                      std::abs(w.z()) * (std::abs(ab) + std::abs(ba));
  if (std::abs(det) > (7 + 56 * unit_roundoff) * unit_roundoff * size) return det > 0 ? 1 : -1;
  if (size == 0) return 0;  // differences that are 0 are so exactly
  if (d == a || d == b || d == c) return 0;
  return exact_side_of_plane(a, b, c, d);
}

TUMBLE_BODY Meeting edge_meets(const Vec3& p, const Vec3& q, const Triangle& t) {
  const int of_p = side_of_plane(t[0], t[1], t[2], p), of_q = side_of_plane(t[0], t[1], t[2], q);
  if (of_p * of_q > 0) return Meeting::apart;
  if (of_p == 0 && of_q == 0) return Meeting::touching;  // in one plane: it may
  std::array<int, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) sides[k] = side_of_plane(p, q, t[k], t[(k + 1) % 3]);
  const bool left = sides[0] > 0 || sides[1] > 0 || sides[2] > 0;
  const bool right = sides[0] < 0 || sides[1] < 0 || sides[2] < 0;
  if (left && right) return Meeting::apart;
  const bool inside = sides[0] * sides[1] * sides[2] != 0 && of_p * of_q != 0;
  return inside ? Meeting::through : Meeting::touching;
}

TUMBLE_BODY Meeting triangles_meet_beside(const Triangle& s, const Triangle& t) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (s[i] == t[j])
        return std::max(edge_meets(s[(i + 1) % 3], s[(i + 2) % 3], t),
                        edge_meets(t[(j + 1) % 3], t[(j + 2) % 3], s));
  return Meeting::apart;
}

TUMBLE_BODY Meeting triangles_meet(const Triangle& s, const Triangle& t) {
  std::array<int, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) sides[k] = side_of_plane(t[0], t[1], t[2], s[k]);
  const auto [least, most] = std::minmax({sides[0], sides[1], sides[2]});
  if (least > 0 || most < 0) return Meeting::apart;
  if (least == 0 && most == 0) return Meeting::touching;  // in one plane: they may
  Meeting closest = Meeting::apart;
  for (std::size_t k = 0; k < 3 && closest != Meeting::through; ++k)
    closest = std::max(
        {closest, edge_meets(s[k], s[(k + 1) % 3], t), edge_meets(t[k], t[(k + 1) % 3], s)});
  return closest;
}

/// How far two triangles overlap along a direction; infinite if there is none.
inline double overlap_along(const Vec3& direction, const Triangle& s, const Triangle& t) {
  const double length = direction.norm();
  if (!(length > 0)) return std::numeric_limits<double>::infinity();
  const auto extent = [&](const Triangle& triangle) {
    const Vec3 n = direction / length;
    return std::minmax(
        {n.dot(triangle[0] - s[0]), n.dot(triangle[1] - s[0]), n.dot(triangle[2] - s[0])});
  };
  const auto [low_s, high_s] = extent(s);
  const auto [low_t, high_t] = extent(t);
  return std::min(high_s - low_t, high_t - low_s);
}

TUMBLE_BODY double parting_distance(const Triangle& s, const Triangle& t) {
  const auto edge = [](const Triangle& of, std::size_t k) { return Vec3(of[(k + 1) % 3] - of[k]); };
  double least = std::min(overlap_along(edge(s, 0).cross(edge(s, 1)), s, t),
                          overlap_along(edge(t, 0).cross(edge(t, 1)), s, t));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, overlap_along(edge(s, i).cross(edge(t, j)), s, t));
  return std::max(least, 0.0);
}

TUMBLE_BODY TriangleCrossing measure_crossing(const Triangle& s, const Triangle& t) {
  TriangleCrossing result{Vec3::Zero(), 0};
  std::array<Vec3, 6> places;
  int count = 0;
  const auto add = [&](const Vec3& p, const Vec3& q, const Triangle& of) {
    if (edge_meets(p, q, of) != Meeting::through) return;
    const Vec3 n = (of[1] - of[0]).cross(of[2] - of[0]);
    const double above = n.dot(p - of[0]), below = n.dot(q - of[0]);
    const double part = above / (above - below);  // of the way; rounding may have made it anything
    const Vec3 place = p + std::clamp(std::isfinite(part) ? part : 0.5, 0.0, 1.0) * (q - p);
    places[static_cast<std::size_t>(count++)] = place;
    result.place += place;
    result.depth = std::max(result.depth, depth_of_edge(p, q, of));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    add(s[k], s[(k + 1) % 3], t);
    add(t[k], t[(k + 1) % 3], s);
  }
  result.place /= count;
  for (int k = 0; k < count; ++k)
    result.reach =
        std::max(result.reach, (places[static_cast<std::size_t>(k)] - result.place).norm());
  // An edge may pass far through the plane of a triangle, and yet close to its border.
  result.depth = std::min(result.depth, parting_distance(s, t));
  return result;
}

}  // namespace tumble::detail
