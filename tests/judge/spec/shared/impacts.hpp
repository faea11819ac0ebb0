#pragma once
/// @file
/// Bodies that meet at a point, for the specs of chapter 11, and what an impulse there does.

#include "11_when_bodies_meet/contract.hpp"
#include "judge/spec/shared/bodies.hpp"
#include "judge/spec/shared/rigid_body_reference.hpp"
#include "tumble/rotation/skew.hpp"

namespace impacts {

using namespace bodies;

/// The velocity of the body's point that is there.
inline Vec3 velocity_at(const Body& body, const State& state, const Vec3& point) {
  const Derived now = reference::derived(body, state);
  return now.v + now.omega.cross(point - state.x);
}

/// The state after an impulse at a point.
inline State after_impulse(State state, const Vec3& impulse, const Vec3& point) {
  state.P += impulse;
  state.L += (point - state.x).cross(impulse);
  return state;
}

/// I⁻¹ in the world.
inline Mat3 inverse_in_world(const Body& body, const State& state) {
  const Mat3 R = reference::to_matrix(state.q);
  return R * body.I_body_inv * R.transpose();
}

/// 1/m + [r]× I⁻¹ [r]×ᵀ.
inline Mat3 contact_matrix(double mass, const Mat3& inverse, const Vec3& arm) {
  const Mat3 cross = tumble::rotation::skew<double>(arm);
  const Mat3 turning = cross * inverse * cross.transpose();
  return Mat3::Identity() / mass + (turning + turning.transpose()) / 2;
}

inline Mat3 contact_matrix(const Body& body, const State& state, const Vec3& point) {
  return contact_matrix(body.mass, inverse_in_world(body, state), point - state.x);
}

/// A state with |q| = 1, to rounding.
inline State any_unit_state() {
  State state = any_state();
  state.q.normalize();
  return state;
}

/// Two bodies, anywhere and with any motion, and the point at which they meet.
struct Meeting {
  Body a = any_body(), b = any_body();
  State state_a = any_unit_state(), state_b = any_unit_state();
  Vec3 point = (state_a.x + state_b.x) / 2 + any_vector(0.5);

  Mat3 K() const { return contact_matrix(a, state_a, point) + contact_matrix(b, state_b, point); }
  /// Of the first body's point less that of the second one's.
  Vec3 u() const { return velocity_at(a, state_a, point) - velocity_at(b, state_b, point); }
  double energy() const { return reference::energy(a, state_a) + reference::energy(b, state_b); }
  /// After an impulse on the first body, and its negative on the second one.
  Meeting after(const Vec3& impulse) const {
    Meeting next = *this;
    next.state_a = after_impulse(state_a, impulse, point);
    next.state_b = after_impulse(state_b, -impulse, point);
    return next;
  }
};

}  // namespace impacts
