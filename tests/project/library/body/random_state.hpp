#pragma once
/// @file
/// One body, and any of its states.

#include "project/harness/inputs.hpp"
#include "tumble/body/rigid_body.hpp"
#include "tumble/body/state.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::test {

inline const RigidBody<> body(2, Mat3(Vec3(1, 2, 2.5).asDiagonal()));

inline RigidBodyState<> random_state(Random& rng) {
  return {rng.vector(), exp_quaternion<double>(3 * rng.vector()), rng.vector(), rng.vector()};
}

}  // namespace tumble::test
