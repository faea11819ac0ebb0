#pragma once

#include "tumble/simulate/turning_trajectory.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::detail {

TUMBLE_BODY steady::SteadyTorque torque_for_series(const RigidBody<>& body,
                                                   const SteadyForces& forces,
                                                   const steady::SteadyTorque& torque) {
  const Mat3& I = body.I_body();
  const Vec3 moments = I.diagonal();
  if (I != Mat3(moments.asDiagonal())) return torque;
  return {forces, PrincipalAxes{moments, Mat3::Identity()}};
}

}  // namespace tumble::detail
