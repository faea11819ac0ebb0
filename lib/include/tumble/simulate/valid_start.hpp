#pragma once
/// @file
/// The start of a simulation: refused if it means nothing, with a quaternion of moderate length.

#include <cmath>

#include "tumble/body/state.hpp"
#include "tumble/core/require.hpp"

namespace tumble::detail {

/// The same orientation by numbers of about 1, to the last digit.
inline Quat of_moderate_length(const Quat& q) {
  const int exponent = std::ilogb(q.coeffs().cwiseAbs().maxCoeff());
  Quat scaled;
  for (int i = 0; i < 4; ++i) scaled.coeffs()[i] = std::scalbn(q.coeffs()[i], -exponent);
  return scaled;
}

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
