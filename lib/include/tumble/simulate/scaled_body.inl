#pragma once

#include "tumble/simulate/scaled_body.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY MotionScale units_of(const RigidBody<>& body, const RigidBodyState<>& start,
                                 const Wrench<>& net, double span) {
  const MotionScale least = least_sizes(body, span);
  MotionScale scale;
  scale.momentum = std::max({start.P.norm(), net.force.norm() * span, least.momentum});
  scale.length = std::max({start.x.norm(), scale.momentum / body.mass() * span, least.length});
  scale.angular_momentum =
      std::max({start.L.norm(), net.torque.norm() * span, least.angular_momentum});
  return scale;
}

}  // namespace tumble::detail
