#pragma once
/// @file
/// How an orientation changes: q̇ = ½ ⟨0, ω⟩ q.
///
/// Source: Baraff, "Rigid Body Simulation I" (1997), eq. 4-2 and appendix B.

#include "tumble/core/types.hpp"

namespace tumble::rotation {

/// @addtogroup quaternion
/// @{

/// q̇ = ½ ⟨0, ω⟩ q [1/s], ω in world coordinates [rad/s]. The result is a rate, not a rotation.
template <class T>
Quaternion<T> quaternion_dot(const Quaternion<T>& q, const Vector3<T>& omega) {
  const Vector3<T> h = omega / T(2);
  return Quaternion<T>(T(0), h.x(), h.y(), h.z()) * q;
}

/// q̇ = ½ q ⟨0, ω_body⟩ [1/s], for an angular velocity in body coordinates [rad/s].
template <class T>
Quaternion<T> quaternion_dot_body(const Quaternion<T>& q, const Vector3<T>& omega_body) {
  const Vector3<T> h = omega_body / T(2);
  return q * Quaternion<T>(T(0), h.x(), h.y(), h.z());
}

/// @}

}  // namespace tumble::rotation
