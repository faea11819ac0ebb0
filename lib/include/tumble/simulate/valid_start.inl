#pragma once

#include "tumble/simulate/valid_start.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"
#include "tumble/quaternion/normalize.hpp"

namespace tumble::detail {

TUMBLE_BODY RigidBodyState<> valid_start(const RigidBodyState<>& start) {
  require(pack(start).allFinite(), "simulate: the state (", pack(start).transpose(),
          ") is not finite");
  require(!start.q.coeffs().isZero(0), "simulate: the quaternion is zero");
  RigidBodyState<> from = start;
  from.q = of_moderate_length(start.q);
  return from;
}

}  // namespace tumble::detail
