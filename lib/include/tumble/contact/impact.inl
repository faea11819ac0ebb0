#pragma once

#include "tumble/contact/impact.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::contact {

TUMBLE_BODY ImpactResult collide(const Impact& impact) {
  impact.require_valid();
  const double u_n = impact.u.dot(impact.normal);
  if (u_n >= 0) return {.u = impact.u};
  const double j = -(1 + impact.e) * u_n / impact.normal.dot(impact.K * impact.normal);
  const Vec3 impulse = j * impact.normal, after = impact.u + impact.K * impulse;
  return {impulse, after, energy_of(impact.u, after, impulse), Slip::kept, false};
}

}  // namespace tumble::contact
