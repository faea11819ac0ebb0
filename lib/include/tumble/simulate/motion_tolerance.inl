#pragma once

#include "tumble/simulate/motion_tolerance.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::detail {

TUMBLE_BODY MotionScale least_sizes(const RigidBody<>& body, double span) {
  constexpr double small = 1e-3;
  const double inertia = body.I_body().trace() / 3;
  const double length = small * std::sqrt(inertia / body.mass());
  return {length, body.mass() * length / span, small * inertia / span};
}

TUMBLE_BODY double rounding_of_moments(const Mat3& I_body, double smallest_moment) {
  if (I_body.isDiagonal(0)) return 0;
  constexpr double roundings = 4;
  return roundings * unit_roundoff * I_body.trace() / smallest_moment;
}

}  // namespace tumble::detail
