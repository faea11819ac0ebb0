#pragma once
/// @file
/// The right answers of this chapter, from lib/, on the types of its contract.

#include "09_rigid_body/contract.hpp"
#include "tumble/body/state.hpp"

namespace reference {

using rigid_body::PackedState, rigid_body::State;

inline PackedState pack(const State& state) {
  return tumble::pack<double>(
      {state.x, tumble::from_coefficients<double>(state.q), state.P, state.L});
}

inline State unpack(const PackedState& y) {
  const tumble::RigidBodyState<> state = tumble::unpack<double>(y);
  return {state.x, tumble::coefficients(state.q), state.P, state.L};
}

}  // namespace reference
