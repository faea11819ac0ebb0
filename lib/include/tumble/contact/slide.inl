#pragma once

#include "tumble/contact/slide.hpp"

#include <limits>

#include "tumble/core/compiled.hpp"

namespace tumble::contact::detail {

TUMBLE_BODY std::optional<Vec3> steady_spin(const Colliding& c, const Vec3& normal) {
  const Mat3 R = to_matrix(c.state.q);
  const Vec3 about = R * (c.body.I_body() * (R.transpose() * normal));  // L for ω = the normal
  const double moment = normal.dot(about), spin = derived(c.body, c.state).omega.dot(normal);
  if (spin != 0 && (about - moment * normal).norm() > 1e-12 * moment) return {};
  return Vec3(moment * spin * normal);
}

TUMBLE_BODY std::optional<Slide> slide_of(const Colliding& c, const collide::Convex& shape,
                                          const Vec3& normal, const Vec3& gravity, double mu,
                                          const Stillness& still) {
  const double pull = -normal.dot(gravity), mass = c.body.mass();
  const Derived<> now = derived(c.body, c.state);
  const Vec3 downhill = gravity + pull * normal, v = now.v - now.v.dot(normal) * normal;
  const bool moves = v.norm() > still.speed, held = downhill.norm() <= (mu + 1e-12) * pull;
  const bool spins = std::abs(now.omega.dot(normal)) * shape.reach() > still.speed;
  if (!moves && held && (mu > 0 || !spins)) return {};
  const Vec3 ahead = moves ? v.normalized() : downhill.normalized();
  if (mu > 0 && ahead.cross(downhill).norm() > 1e-9 * gravity.norm()) return {};  // it curves
  const std::optional<Vec3> L = mu > 0 ? Vec3(Vec3::Zero()) : steady_spin(c, normal);
  if (!L) return {};
  Slide slide{{c.state.x, c.state.q, moves ? mass * v : Vec3(Vec3::Zero()), *L},
              downhill - mu * pull * ahead,
              std::numeric_limits<double>::infinity()};
  const double to_tilt = still.lift * mass * pull * shape.reach();
  if (kinetic_energy(c.body, c.state) - kinetic_energy(c.body, slide.state) > to_tilt) return {};
  if (!stands_on(c, shape, normal, gravity - slide.acceleration, still.near * shape.reach()))
    return {};
  const double gains = ahead.dot(slide.acceleration);
  if (mu > 0 && gains < 0) slide.stops = v.norm() / -gains;
  return slide;
}

}  // namespace tumble::contact::detail
