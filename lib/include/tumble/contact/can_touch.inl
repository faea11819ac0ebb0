#pragma once

#include "tumble/contact/can_touch.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/core/compiled.hpp"

namespace tumble::contact::detail {

TUMBLE_BODY double lowest(double h, double v, double a, double until) {
  const double turn = -v / a;
  if (a > 0 && turn > 0 && turn < until) return h + v * turn / 2;
  return std::min(h, h + until * (v + until / 2 * a));
}

TUMBLE_BODY bool reaches(const collide::Parabola& path, double radius,
                         const collide::HalfSpace& wall, double until) {
  const Vec3& n = wall.normal;
  const double above = lowest(n.dot(path.x - wall.point), n.dot(path.v), n.dot(path.a), until);
  return !(above > radius + path_rounding * (size_of(path, until) + wall.point.norm() + radius));
}

TUMBLE_BODY bool reaches(const collide::Parabola& a, const collide::Parabola& b, double radii,
                         double until) {
  const Vec3 apart = b.x - a.x, v = b.v - a.v;
  const double nearest = v.isZero(0) ? 0 : std::clamp(-apart.dot(v) / v.squaredNorm(), 0., until);
  const double rounding = path_rounding * (size_of(a, until) + size_of(b, until) + radii);
  return !((apart + nearest * v).norm() > radii + rounding);
}

TUMBLE_BODY bool any_pair_meets(const ContactScene& scene, double until) {
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

TUMBLE_BODY bool can_touch(const ContactScene& scene, double until) {
  require(until >= 0 && std::isfinite(until), "contacts: until = ", until,
          " s is not finite and ≥ 0");
  for (const ContactBody& b : scene.bodies) {
    const collide::Parabola path = detail::free_path(b, scene.gravity);
    for (const collide::HalfSpace& wall : scene.walls)
      if (detail::reaches(path, b.shape.reach(), wall, until)) return true;
  }
  return detail::any_pair_meets(scene, until);
}

}  // namespace tumble::contact
