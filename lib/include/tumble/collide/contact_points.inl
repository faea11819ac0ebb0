#pragma once

#include "tumble/collide/contact_points.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::collide::detail {

TUMBLE_BODY std::vector<Flat> lower_hull(const std::vector<Flat>& points, double width) {
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

TUMBLE_BODY std::vector<Flat> flat_hull(std::vector<Flat> points, double width) {
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

TUMBLE_BODY std::vector<Flat> left_of(const std::vector<Flat>& polygon, const Flat& a,
                                      const Flat& b, double width) {
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

TUMBLE_BODY std::vector<Flat> common_part(std::vector<Flat> p, std::vector<Flat> q, double width) {
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

TUMBLE_BODY ContactPoints contact_points(const Convex& body, const Pose& pose,
                                         const Distance& found, double tolerance) {
  const double most = found.normal.dot(found.arm_a) - body.radius();
  ContactPoints points;
  for (const Vec3& p : body.points()) {
    const Vec3 arm = pose.R * p;
    if (found.normal.dot(arm) >= most - tolerance)
      points.push_back(arm + body.radius() * found.normal);
  }
  return points;
}

TUMBLE_BODY ContactPoints contact_points(const Convex& a, const Pose& pose_a, const Convex& b,
                                         const Pose& pose_b, const Distance& found,
                                         double tolerance) {
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

}  // namespace tumble::collide
