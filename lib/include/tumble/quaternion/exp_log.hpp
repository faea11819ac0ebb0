#pragma once
/// @file
/// Rotation vector θ u ↔ unit quaternion, exact to rounding for every angle; and the rotation
/// vector of a matrix.
///
/// exp: q = (cos ½θ, sin ½θ u);  log: θ = 2 atan2(|v|, w), which is as good at 0 as at π (acos is
/// not). Source: Grassia, "Practical parameterization of rotations using the exponential map", J.
/// Graphics Tools 3 (1998), eqs. 2–5.

#include <cmath>

#include "tumble/core/sinc.hpp"
#include "tumble/core/types.hpp"
#include "tumble/quaternion/convert.hpp"

namespace tumble {

/// @addtogroup quaternion
/// @{

/// The unit quaternion of the rotation by |w| radians about the direction of w.
/// @param w rotation vector [rad], any length
template <class T>
Quaternion<T> exp_quaternion(const Vector3<T>& w) {
  using std::cos;
  const T half = w.norm() / T(2);
  const Vector3<T> v = (detail::sinc(half) / T(2)) * w;
  return Quaternion<T>(cos(half), v.x(), v.y(), v.z());
}

/// The rotation vector of q [rad], the short way round: its length is in [0, π].
/// @param q any quaternion but zero; q and −q give the same vector (at π, one of ±)
template <class T>
Vector3<T> log_quaternion(const Quaternion<T>& q) {
  using std::atan2;
  const T w = q.w() < T(0) ? -q.w() : q.w();
  const Vector3<T> v = q.w() < T(0) ? Vector3<T>(-q.vec()) : Vector3<T>(q.vec());
  const T sine = v.stableNorm();
  if (sine == T(0)) return Vector3<T>::Zero();
  return (T(2) * atan2(sine, w) / sine) * v;
}

/// The rotation vector of R [rad], with length in [0, π]. At π both ±w are right; one is returned.
/// The logarithm goes through the quaternion, whose log is smooth at π.
/// @throws std::invalid_argument if R is not near a rotation matrix
inline Vec3 log_rotation(const Mat3& R) { return log_quaternion(from_matrix(R)); }

/// The angle [rad] of the turn that takes orientation a to orientation b, in [0, π]; the
/// signs of the quaternions do not matter. This is the error measure for orientations in all
/// tests and tables.
template <class T>
T angle_between(const Quaternion<T>& a, const Quaternion<T>& b) {
  return log_quaternion<T>(a.conjugate() * b).norm();
}

/// @}

}  // namespace tumble
