#pragma once

#include "tumble/body/held_body.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY SteadyForces about_point(const HeldBody& held, const SteadyForces& forces) {
  SteadyForces turning{.angular_drag = forces.angular_drag};
  turning.at_point = forces.at_point;
  turning.at_point.push_back({forces.force, -held.held()});
  return turning;
}

}  // namespace tumble::detail
