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

/// What a ball passes, as one sees it who falls along: gravity moves all of them alike.
inline collide::Bounds swept_falling_along(const collide::Parabola& path, double until,
                                           double radius) {
  return collide::swept_bounds({path.x, path.v, Vec3::Zero()}, until, radius);
}

/// Whether any two bodies meet. Of many, those are compared whose swept bounds overlap.
inline bool any_pair_meets(const ContactScene& scene, double until) {
  constexpr std::size_t few = 24;
  const std::vector<ContactBody>& bodies = scene.bodies;
  if (bodies.size() < 2) return false;
  std::vector<collide::Parabola> paths;
  paths.reserve(bodies.size());
  for (const ContactBody& b : bodies) paths.push_back(free_path(b, scene.gravity));
  bool meet = false;
  const auto compare = [&](std::size_t a, std::size_t b) {
    meet = meet ||
           reaches(paths[a], paths[b], bodies[a].shape.reach() + bodies[b].shape.reach(), until);
  };
  if (paths.size() <= few) {
    for (std::size_t a = 1; a < paths.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) compare(a, b);
    return meet;
  }
  std::vector<collide::Bounds> swept;
  swept.reserve(bodies.size());
  for (std::size_t i = 0; i < paths.size(); ++i)
    swept.push_back(swept_falling_along(paths[i], until, bodies[i].shape.reach()));
  collide::sort_and_sweep(swept, [&](int a, int b) {
    compare(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  });
  return meet;
}

}  // namespace tumble::contact::detail

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// Whether any body can touch a wall or another body from t = 0 to `until`: whether the balls
/// around the centres of mass which hold the bodies meet on their flights. It takes some products
/// per body, and a sort.
/// @param until [s], finite and ≥ 0
/// @return false only if nothing touches, to rounding. True does not promise that something does.
/// @throws std::invalid_argument if `until` is none
inline bool can_touch(const ContactScene& scene, double until) {
  require(until >= 0 && std::isfinite(until), "contacts: until = ", until,
          " s is not finite and ≥ 0");
  for (const ContactBody& b : scene.bodies) {
    const collide::Parabola path = detail::free_path(b, scene.gravity);
    for (const collide::HalfSpace& wall : scene.walls)
      if (detail::reaches(path, b.shape.reach(), wall, until)) return true;
  }
  return detail::any_pair_meets(scene, until);
}

/// @}

}  // namespace tumble::contact
