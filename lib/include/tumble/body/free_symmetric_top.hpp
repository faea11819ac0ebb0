#pragma once
/// @file
/// Where a body with two equal moments is after any time, when nothing pushes it: sines, no steps.
///
/// ω = L/A + (1/C − 1/A)(L·n) n with n the axis of symmetry, so that
///   q(t) = exp(t L/A) q(0) exp(t (1/C − 1/A)(L·n) n_body)
/// Source: Landau & Lifshitz, "Mechanics" (1976), §33, the regular precession.

#include "tumble/body/model.hpp"
#include "tumble/body/state.hpp"
#include "tumble/core/require.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble {

/// The state of a free symmetric top (or ball) after the time t.
/// @param body two of its principal moments must be equal
/// @param t    [s], any length, also negative
/// @throws std::invalid_argument if the body is not symmetric to rounding
inline RigidBodyState<> free_symmetric_top(const RigidBody<>& body, const RigidBodyState<>& start,
                                           double t) {
  const SymmetricMoments top = nearest_symmetric_top(body);
  require(top.asymmetry <= 4 * inertia_rounding,
          "free_symmetric_top: no two principal moments are ", "equal; the nearest differ by ",
          top.asymmetry, " of their size");
  const double L_axial = start.L.dot(start.q * top.axis);
  const double spin = (1 / top.axial - 1 / top.transverse) * L_axial;
  const Quat about_L = exp_quaternion<double>(t / top.transverse * start.L);
  const Quat about_axis = exp_quaternion<double>(t * spin * top.axis);
  return {start.x + t / body.mass() * start.P, about_L * start.q * about_axis, start.P, start.L};
}

}  // namespace tumble
