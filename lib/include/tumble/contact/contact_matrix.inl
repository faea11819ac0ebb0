#pragma once

#include "tumble/contact/contact_matrix.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/rotation/skew.hpp"

namespace tumble::contact {

TUMBLE_BODY Mat3 contact_matrix(const RigidBody<>& body, const Derived<>& now, const Vec3& point) {
  const Mat3 arm = rotation::skew<double>(point - now.x);
  // I⁻¹ in the world; −[r]× I⁻¹ [r]× = [r]× I⁻¹ [r]×ᵀ, which rounding leaves symmetric.
  const Mat3 inverse = now.R * body.I_body_inv() * now.R.transpose();
  const Mat3 turning = arm * inverse * arm.transpose();
  return Mat3::Identity() / body.mass() + (turning + turning.transpose()) / 2;
}

TUMBLE_BODY RigidBodyState<> after_impulse(const RigidBodyState<>& state, const Vec3& impulse,
                                           const Vec3& point) {
  RigidBodyState<> after = state;
  after.P += impulse;
  after.L += (point - state.x).cross(impulse);
  return after;
}

}  // namespace tumble::contact
