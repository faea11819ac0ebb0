#pragma once
/// @file
/// What the hard cases share: bodies with principal axes, how they start, and the truth.

#include "project/harness/inputs.hpp"
#include "reference/long_free_turning.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::test {

inline RigidBody<> body_with(const Vec3& J, double mass = 1) {
  return RigidBody<>(mass, Mat3(J.asDiagonal()));
}

/// In the origin, its axes along the world's.
inline RigidBodyState<> turning(const Vec3& J, const Vec3& omega) {
  return {Vec3::Zero(), Quat(1, 0, 0, 0), Vec3::Zero(), J.cwiseProduct(omega)};
}

/// Where the free body is, to 1e-15 and better.
inline reference::LongFreeTurning truth_of(const Vec3& J, const RigidBodyState<>& start) {
  return reference::LongFreeTurning({J, start.q, start.L});
}

}  // namespace tumble::test
