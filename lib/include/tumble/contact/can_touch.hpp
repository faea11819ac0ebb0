#pragma once
/// @file
/// Whether anything can touch at all. Where nothing can, no search for contacts has to run.

#include <algorithm>
#include <cmath>
#include <limits>

#include "tumble/contact/scene.hpp"

namespace tumble::contact::detail {

/// Of all numbers that a distance is made of, what rounding may have changed.
inline constexpr double path_rounding = 32 * std::numeric_limits<double>::epsilon();

/// The way of a body's centre, as long as the body touches nothing.
inline collide::Parabola free_path(const ContactBody& b, const Vec3& gravity) {
  return {b.start.x, b.start.P / b.body.mass(), gravity};
}

/// Bound on the coordinates of a path.
inline double size_of(const collide::Parabola& path, double until) {
  return path.x.norm() + until * (path.v.norm() + until / 2 * path.a.norm());
}

/// The least value of h + v s + a s²/2 for 0 ≤ s ≤ until.
inline double lowest(double h, double v, double a, double until) {
  const double turn = -v / a;
  if (a > 0 && turn > 0 && turn < until) return h + v * turn / 2;
  return std::min(h, h + until * (v + until / 2 * a));
}

/// Whether a ball on its path reaches the wall.
inline bool reaches(const collide::Parabola& path, double radius, const collide::HalfSpace& wall,
                    double until) {
  const Vec3& n = wall.normal;
  const double above = lowest(n.dot(path.x - wall.point), n.dot(path.v), n.dot(path.a), until);
  return !(above > radius + path_rounding * (size_of(path, until) + wall.point.norm() + radius));
}

/// Whether two balls meet that fall alike: seen from one, the other goes straight on.
inline bool reaches(const collide::Parabola& a, const collide::Parabola& b, double radii,
                    double until) {
  const Vec3 apart = b.x - a.x, v = b.v - a.v;
  const double nearest = v.isZero(0) ? 0 : std::clamp(-apart.dot(v) / v.squaredNorm(), 0., until);
  const double rounding = path_rounding * (size_of(a, until) + size_of(b, until) + radii);
  return !((apart + nearest * v).norm() > radii + rounding);
}

}  // namespace tumble::contact::detail

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// Whether any body can touch a wall or another body from t = 0 to `until`: whether the balls
/// around the centres of mass which hold the bodies meet on their flights. It takes some products a
/// body, and a sort.
/// @param until [s], finite and ≥ 0
/// @return false only if nothing touches, to rounding. True is no promise that something does.
/// @throws std::invalid_argument if `until` is none, or a start is not finite
inline bool can_touch(const ContactScene& scene, double until) {
  require(until >= 0 && std::isfinite(until), "contacts: until = ", until,
          " s is not finite and ≥ 0");
  std::vector<collide::Bounds> swept;
  for (const ContactBody& b : scene.bodies) {
    const collide::Parabola path = detail::free_path(b, scene.gravity);
    for (const collide::HalfSpace& wall : scene.walls)
      if (detail::reaches(path, b.shape.reach(), wall, until)) return true;
    if (scene.bodies.size() > 1)
      swept.push_back(collide::swept_bounds(path, until, b.shape.reach()));
  }
  bool meet = false;
  collide::sort_and_sweep(swept, [&](int i, int j) {
    const ContactBody &a = scene.body(i), &b = scene.body(j);
    meet = meet || detail::reaches(detail::free_path(a, scene.gravity),
                                   detail::free_path(b, scene.gravity),
                                   a.shape.reach() + b.shape.reach(), until);
  });
  return meet;
}

/// @}

}  // namespace tumble::contact
