#pragma once
/// @file
/// How an orientation changes: Ṙ = [ω]× R. Each column, an axis of the body, moves as ω × axis.
///
/// Source: Baraff, "An Introduction to Physically Based Modeling: Rigid Body Simulation I"
/// (1997), eq. 2-11.

#include "tumble/core/types.hpp"
#include "tumble/rotation/skew.hpp"

namespace tumble::rotation {

/// @addtogroup rotation
/// @{

/// Ṙ = [ω]× R [1/s].
/// @param R     orientation, body → world
/// @param omega angular velocity in world coordinates [rad/s]
template <class T>
Matrix3<T> rotation_dot(const Matrix3<T>& R, const Vector3<T>& omega) {
  return skew(omega) * R;
}

/// Ṙ = R [ω_body]× [1/s], for an angular velocity in body coordinates [rad/s].
template <class T>
Matrix3<T> rotation_dot_body(const Matrix3<T>& R, const Vector3<T>& omega_body) {
  return R * skew(omega_body);
}

/// The angular velocity in world coordinates [rad/s] that turns R at the rate R_dot: [ω]× = Ṙ Rᵀ.
template <class T>
Vector3<T> angular_velocity_of(const Matrix3<T>& R, const Matrix3<T>& R_dot) {
  return unskew<T>(R_dot * R.transpose());
}

/// @}

}  // namespace tumble::rotation
