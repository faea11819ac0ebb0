#pragma once
/// @file
/// Where two bodies that touch do so: at one point, along an edge, or over a face, whose corners
/// are given.

#include "tumble/collide/distance.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// The points of contact of two bodies, from the centre of the first one, in world axes [m].
using ContactPoints = std::vector<Vec3>;

/// @}

}  // namespace tumble::collide

namespace tumble::collide::detail {

using Flat = Eigen::Vector2d;

inline double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Half of the hull of sorted points, from the first one to the last one.
inline std::vector<Flat> lower_hull(const std::vector<Flat>& points, double width) {
  std::vector<Flat> hull;
  for (const Flat& p : points) {
    const auto bulges = [&] {
      const Flat &a = hull[hull.size() - 2], &b = hull.back();
      return turn(a, b, p) > width * (p - a).norm();
    };
    while (hull.size() > 1 && !bulges()) hull.pop_back();
    hull.push_back(p);
  }
  return hull;
}

/// The corners of the hull of points in a plane, counter-clockwise. What is narrower than `width`
/// is a segment or a point.
inline std::vector<Flat> flat_hull(std::vector<Flat> points, double width) {
  std::sort(points.begin(), points.end(), [](const Flat& p, const Flat& q) {
    return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
  });
  std::vector<Flat> hull = lower_hull(points, width);
  std::reverse(points.begin(), points.end());
  const std::vector<Flat> upper = lower_hull(points, width);
  hull.insert(hull.end(), upper.begin() + 1, upper.end());
  if (hull.size() > 1) hull.pop_back();
  if (hull.size() == 2 && (hull[0] - hull[1]).norm() <= width) hull.pop_back();
  return hull;
}

/// What a polygon or a segment keeps on the left of the line from a to b, or `width` beside it.
/// Source: Sutherland & Hodgman, "Reentrant polygon clipping", CACM 17(1) (1974).
inline std::vector<Flat> left_of(const std::vector<Flat>& polygon, const Flat& a, const Flat& b,
                                 double width) {
  const double beside = width * (b - a).norm();
  std::vector<Flat> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Flat &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = turn(a, b, p) + beside, at_q = turn(a, b, q) + beside;
    if (at_p >= 0) kept.push_back(p);
    if ((at_p < 0) != (at_q < 0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

/// What two hulls in a plane share; nothing if rounding does not let it be told.
inline std::vector<Flat> common_part(std::vector<Flat> p, std::vector<Flat> q, double width) {
  if (q.size() < p.size()) std::swap(p, q);
  if (p.size() < 2) return p;
  if (q.size() == 2) {  // two edges: along each other, or they cross in a point
    const Flat along = (q[1] - q[0]).normalized(), side(-along.y(), along.x());
    if (std::abs(side.dot(p[1] - p[0])) > width) return {};
    return left_of(left_of(p, q[0], q[0] - side, width), q[1], q[1] + side, width);
  }
  for (std::size_t i = 0; i < q.size(); ++i) p = left_of(p, q[i], q[(i + 1) % q.size()], width);
  return p;
}

}  // namespace tumble::collide::detail

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// Where a body touches a floor or a wall: its points that are no farther than `tolerance` from the
/// nearest one.
inline ContactPoints contact_points(const Convex& body, const Pose& pose, const Distance& found,
                                    double tolerance) {
  const double most = found.normal.dot(found.arm_a) - body.radius();
  ContactPoints points;
  for (const Vec3& p : body.points()) {
    const Vec3 arm = pose.R * p;
    if (found.normal.dot(arm) >= most - tolerance)
      points.push_back(arm + body.radius() * found.normal);
  }
  return points;
}

/// Where two bodies touch: the corners of what their faces share, or the nearest points.
/// @param found     their distance, a's first
/// @param tolerance how far from its plane a point may be [m]
inline ContactPoints contact_points(const Convex& a, const Pose& pose_a, const Convex& b,
                                    const Pose& pose_b, const Distance& found, double tolerance) {
  const Vec3 offset = pose_b.x - pose_a.x, n = found.normal;
  const Vec3 middle = (found.arm_a + (offset + found.arm_b)) / 2;
  if (a.points().size() == 1 || b.points().size() == 1) return {middle};
  Distance swapped = found;
  swapped.normal = -n;
  swapped.arm_a = found.arm_b;
  const Vec3 x = n.unitOrthogonal(), y = n.cross(x);
  const auto flat = [&](const ContactPoints& arms, const Vec3& from) {
    std::vector<detail::Flat> points;
    for (const Vec3& arm : arms) points.emplace_back(x.dot(from + arm), y.dot(from + arm));
    return detail::flat_hull(std::move(points), tolerance);
  };
  const auto shared =
      detail::common_part(flat(contact_points(a, pose_a, found, tolerance), Vec3::Zero()),
                          flat(contact_points(b, pose_b, swapped, tolerance), offset), tolerance);
  ContactPoints points;
  if (shared.size() < 2) return {middle};
  for (const detail::Flat& p : shared) points.push_back(p.x() * x + p.y() * y + n.dot(middle) * n);
  return points;
}

/// @}

}  // namespace tumble::collide
