#pragma once
/// @file
/// The start of a simulation: refused if it means nothing, with a quaternion of moderate length.

#include "tumble/body/state.hpp"
#include "tumble/core/require.hpp"
#include "tumble/quaternion/normalize.hpp"

namespace tumble::detail {

/// The start, its quaternion with numbers of about 1.
/// @throws std::invalid_argument if a number is not finite, or the quaternion zero
inline RigidBodyState<> valid_start(const RigidBodyState<>& start) {
  require(pack(start).allFinite(), "simulate: the state (", pack(start).transpose(),
          ") is not finite");
  require(!start.q.coeffs().isZero(0), "simulate: the quaternion is zero");
  RigidBodyState<> from = start;
  from.q = of_moderate_length(start.q);
  return from;
}

}  // namespace tumble::detail
