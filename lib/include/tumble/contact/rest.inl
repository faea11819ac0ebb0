#pragma once

#include "tumble/contact/rest.hpp"

#include "tumble/collide/contact_points.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::contact::detail {

TUMBLE_BODY bool rolls_on(const Colliding& ball, double radius, const Vec3& normal,
                          const Vec3& gravity, double mu) {
  constexpr double rounding = 1e-9;
  const Derived<> now = derived(ball.body, ball.state);
  const Vec3 across = now.omega.cross(radius * normal), slip = now.v - across;
  const double sideways = gravity.cross(normal).norm();
  const double slips = (slip - slip.dot(normal) * normal).norm();
  return sideways <= 1e-12 * gravity.norm() &&
         (mu == 0 || slips <= rounding * (now.v.norm() + across.norm()));
}

TUMBLE_BODY bool stands_on(const Colliding& c, const collide::Convex& shape, const Vec3& normal,
                           const Vec3& pull, double near) {
  const double little = 1e-9 * shape.reach();
  const collide::Pose pose{Vec3::Zero(), to_matrix(c.state.q)};
  const auto below = distance(shape, pose, collide::HalfSpace{Vec3::Zero(), normal});
  const auto points = contact_points(shape, pose, below, near);
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  const Vec3 foot = pull * (normal.dot(below.arm_a) / normal.dot(pull));
  std::vector<Eigen::Vector2d> feet;
  for (const Vec3& p : points) feet.emplace_back(x.dot(p - foot), y.dot(p - foot));
  const auto hull = collide::detail::flat_hull(std::move(feet), little);
  if (hull.size() == 1) return hull[0].norm() < little;
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (collide::detail::turn(hull[i], hull[(i + 1) % hull.size()], {0, 0}) < 0) return false;
  return hull.size() > 2;
}

TUMBLE_BODY bool is_at_rest(const Colliding& c, const collide::Convex& shape, const Vec3& normal,
                            const Vec3& gravity, double mu, const Stillness& still) {
  const double pull = -normal.dot(gravity), sideways = (gravity + pull * normal).norm();
  if (!(pull > 0) || sideways > (mu + 1e-12) * pull) return false;
  const double reach = shape.reach(), energy = kinetic_energy(c.body, c.state);
  const double to_tilt = still.lift * c.body.mass() * pull * reach;
  if (energy > to_tilt) return false;
  const bool is_ball = shape.points().size() == 1;
  const double to_slide = is_ball ? 0 : 10 * to_tilt * (mu - sideways / pull);
  if (energy > to_slide && speed_along(c, reach, normal) > still.speed) return false;
  return stands_on(c, shape, normal, gravity, still.near * reach);
}

}  // namespace tumble::contact::detail
