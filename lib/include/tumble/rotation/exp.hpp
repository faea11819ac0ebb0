#pragma once
/// @file
/// Rotation vector θ u → rotation matrix, exact to rounding from θ = 0 to θ = π. The way back is
/// log_rotation() (quaternion/exp_log.hpp).
///
/// exp: R = 1 + (sin θ/θ) [w]× + ((1 − cos θ)/θ²) [w]×²   (Rodrigues 1840), w = θ u
/// Source: Murray, Li & Sastry (1994), §2.2; (1 − cos θ)/θ² is written ½ (sin(θ/2)/(θ/2))², which
/// does not cancel.

#include "tumble/core/sinc.hpp"
#include "tumble/core/types.hpp"
#include "tumble/rotation/skew.hpp"

namespace tumble {

/// @addtogroup rotation
/// @{

/// The rotation by |w| radians about the direction of w.
/// @param w rotation vector [rad], any length
template <class T>
Matrix3<T> exp_rotation(const Vector3<T>& w) {
  const T theta = w.norm();
  const T half = detail::sinc(theta / T(2));
  const Matrix3<T> W = rotation::skew(w);
  return Matrix3<T>::Identity() + detail::sinc(theta) * W + (half * half / T(2)) * (W * W);
}

/// @}

}  // namespace tumble
