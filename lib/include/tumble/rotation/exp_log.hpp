#pragma once
/// @file
/// Rotation vector θ u ↔ rotation matrix, exact to rounding from θ = 0 to θ = π.
///
/// exp: R = 1 + (sin θ/θ) [w]× + ((1 − cos θ)/θ²) [w]×²   (Rodrigues 1840), w = θ u
/// Source: Murray, Li & Sastry (1994), §2.2; (1 − cos θ)/θ² is written ½ (sin(θ/2)/(θ/2))², which
/// does not cancel. The logarithm goes through the quaternion, whose log is smooth at π.

#include <cmath>

#include "tumble/core/types.hpp"
#include "tumble/quaternion/convert.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/skew.hpp"

namespace tumble {

/// The rotation by |w| radians about the direction of w.
/// @param w rotation vector [rad], any length
template <class T>
Matrix3<T> exp_rotation(const Vector3<T>& w) {
  const T theta = w.norm();
  const T half = sinc(theta / T(2));
  const Matrix3<T> W = skew(w);
  return Matrix3<T>::Identity() + sinc(theta) * W + (half * half / T(2)) * (W * W);
}

/// The rotation vector of R [rad], with length in [0, π]. At π both ±w are right; one is returned.
/// @throws std::invalid_argument if R is not near a rotation matrix
inline Vec3 log_rotation(const Mat3& R) { return log_quaternion(from_matrix(R)); }

}  // namespace tumble
