#pragma once
/// @file
/// The right answers of chapter 9, from lib/, on the types of its contract.

#include <functional>
#include <vector>

#include "09_rigid_body/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "tumble/body/state.hpp"
#include "tumble/ode/rk4.hpp"

namespace reference {

using rigid_body::Body, rigid_body::Derived, rigid_body::PackedState, rigid_body::State;
using rigid_body::Wrench, rigid_body::WrenchAt;

inline PackedState pack(const State& state) {
  return tumble::pack<double>(
      {state.x, tumble::from_coefficients<double>(state.q), state.P, state.L});
}

inline State unpack(const PackedState& y) {
  const tumble::RigidBodyState<> state = tumble::unpack<double>(y);
  return {state.x, tumble::coefficients(state.q), state.P, state.L};
}

/// With the inverse tensor that is given, as a student has it.
inline Derived derived(const Body& body, const State& state) {
  const tumble::Mat3 R = to_matrix(state.q);
  const tumble::Vec3 omega_body = body.I_body_inv * (R.transpose() * state.L);
  return {R, state.P / body.mass, R * omega_body};
}

/// ẏ where the wrench is known.
inline PackedState rate(const Body& body, const State& state, const Wrench& wrench) {
  const Derived now = reference::derived(body, state);
  return pack({now.v, quaternion_dot(state.q, now.omega), wrench.force, wrench.torque});
}

inline PackedState dydt(const Body& body, const WrenchAt& wrench, double t, const PackedState& y) {
  const State state = unpack(y);
  return rate(body, state, wrench(t, state));
}

using Rhs = std::function<PackedState(double t, const PackedState& y)>;

inline Rhs right_hand_side(const Body& body, const WrenchAt& wrench) {
  return [=](double t, const PackedState& y) { return reference::dydt(body, wrench, t, y); };
}

inline std::vector<State> simulate(const Body& body, const WrenchAt& wrench, const State& start,
                                   double t0, double t1, int steps) {
  const Rhs rhs = right_hand_side(body, wrench);
  const double step = (t1 - t0) / steps;
  std::vector<State> path(static_cast<std::size_t>(steps) + 1, start);
  for (std::size_t n = 1; n < path.size(); ++n) {
    const double time = t0 + static_cast<double>(n - 1) * step;
    path[n] = unpack(tumble::runge_kutta::rk4_step(rhs, time, reference::pack(path[n - 1]), step));
    path[n].q.normalize();
  }
  return path;
}

/// ½ P·v + ½ L·ω [J].
inline double energy(const Body& body, const State& state) {
  const Derived now = reference::derived(body, state);
  return (state.P.dot(now.v) + state.L.dot(now.omega)) / 2;
}

}  // namespace reference
