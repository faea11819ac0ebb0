#pragma once
/// @file
/// Bodies and states that the specs of this chapter try.

#include "09_rigid_body/contract.hpp"
#include "judge/spec/spec.hpp"

namespace bodies {

using namespace tumble::judge;
using rigid_body::PackedState, rigid_body::Quaternion, rigid_body::State;
using tumble::Mat3, tumble::Vec3;

/// A state whose quaternion has any length, with numbers of the given size.
inline State any_state(double size = 3) {
  const Vec3 x = any_vector(size);
  const Quaternion q = any_quaternion(size);
  const Vec3 P = any_vector(size), L = any_vector(size);
  return {x, q, P, L};
}

}  // namespace bodies
