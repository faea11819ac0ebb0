#pragma once

#include "tumble/contact/friction_impulse.hpp"

#include <limits>

#include "tumble/contact/sliding.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::contact::detail {

TUMBLE_BODY Mat3 contact_axes(const Vec3& normal) {
  Mat3 axes;
  axes.col(2) = normal;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

}  // namespace tumble::contact::detail

namespace tumble::contact {

TUMBLE_BODY ImpactResult collide_with_friction(const Impact& impact) {
  if (impact.mu == 0) return collide(impact);
  impact.require_valid();
  if (impact.u.dot(impact.normal) >= 0) return {.u = impact.u};
  const Mat3 axes = detail::contact_axes(impact.normal);
  const double speed = impact.u.norm(), ease = impact.K.norm();
  detail::Contact contact(axes.transpose() * (impact.K / ease) * axes,
                          axes.transpose() * (impact.u / speed), impact.mu, impact.e);
  contact.run();
  Vec3 impulse = speed / ease * (axes * contact.impulse());
  detail::Outcome outcome(impact, impulse);
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  if (outcome.energy > rounding * speed * impulse.norm()) {
    // E(c j) = c u·j + c² j·K j/2 is 0 for c = w/(w + E), w = −u·j, and below 0 for less: by what
    // rounding c j adds.
    const double w = -impact.u.dot(impulse);
    constexpr double sum = 8 * std::numeric_limits<double>::epsilon();
    impulse *= w / (w + outcome.energy) * (1 - sum * outcome.u.norm() * impulse.norm() / w);
    outcome = detail::Outcome(impact, impulse);
  }
  return {impulse, outcome.u, outcome.energy, contact.slip(), contact.jammed()};
}

}  // namespace tumble::contact
