#pragma once
/// @file
/// Quaternion ↔ rotation matrix, axis and angle, four numbers. Products, inverses and the rotation
/// of a vector are Eigen's own: q1 * q2, q.conjugate(), q * v.
///
/// Source: Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985; the four branches:
/// Shepperd, J. Guidance and Control 1 (1978) 223–224.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"
#include "tumble/rotation/orthonormality.hpp"

namespace tumble {

/// @addtogroup quaternion
/// @{

/// The numbers (w, x, y, z) of a quaternion, the order of text and of state vectors.
template <class T>
Eigen::Matrix<T, 4, 1> coefficients(const Quaternion<T>& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

/// The quaternion with the numbers (w, x, y, z).
template <class T>
Quaternion<T> from_coefficients(const Eigen::Matrix<T, 4, 1>& wxyz) {
  return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

/// The rotation matrix of q/|q|, body → world: orthonormal to rounding however far |q| has drifted.
/// @param q any quaternion whose squared length is a double: from 1e-150 to 1e150
template <class T>
Matrix3<T> to_matrix(const Quaternion<T>& q) {
  const T s = T(2) / q.squaredNorm();
  const T wx = s * q.w() * q.x(), wy = s * q.w() * q.y(), wz = s * q.w() * q.z();
  const T xx = s * q.x() * q.x(), xy = s * q.x() * q.y(), xz = s * q.x() * q.z();
  const T yy = s * q.y() * q.y(), yz = s * q.y() * q.z(), zz = s * q.z() * q.z();
  Matrix3<T> R;
  // clang-format off
  R << T(1) - (yy + zz), xy - wz,          xz + wy,
       xy + wz,          T(1) - (xx + zz), yz - wx,
       xz - wy,          yz + wx,          T(1) - (xx + yy);
  // clang-format on
  return R;
}

/// The unit quaternion of a rotation matrix; of the two, the one with its largest number positive.
/// @param R a rotation matrix, body → world, or one that has drifted a little
/// @throws std::invalid_argument if R is no rotation even roughly: a reflection, a scaling, NaN
inline Quat from_matrix(const Mat3& R) {
  require(rotation::is_rotation(R, 0.1),
          "from_matrix: not a rotation matrix (orthonormality error ",
          rotation::orthonormality_error(R), ", determinant ", R.determinant(), "):\n", R);
  // 4w², 4x², 4y², 4z²: at least one is ≥ 1, and dividing by its root loses nothing.
  const Eigen::Vector4d squares(1 + R(0, 0) + R(1, 1) + R(2, 2), 1 + R(0, 0) - R(1, 1) - R(2, 2),
                                1 - R(0, 0) + R(1, 1) - R(2, 2), 1 - R(0, 0) - R(1, 1) + R(2, 2));
  int largest = 0;
  squares.maxCoeff(&largest);
  const double wx = R(2, 1) - R(1, 2), wy = R(0, 2) - R(2, 0), wz = R(1, 0) - R(0, 1);
  const double xy = R(1, 0) + R(0, 1), xz = R(0, 2) + R(2, 0), yz = R(2, 1) + R(1, 2);
  Quat q;
  switch (largest) {
    case 0:
      q = Quat(squares[0], wx, wy, wz);
      break;
    case 1:
      q = Quat(wx, squares[1], xy, xz);
      break;
    case 2:
      q = Quat(wy, xy, squares[2], yz);
      break;
    default:
      q = Quat(wz, xz, yz, squares[3]);
      break;
  }
  return q.normalized();
}

/// The rotation by `angle` about `axis`: (cos ½θ, sin ½θ u).
/// @param axis  any length but zero
/// @param angle [rad]
/// @throws std::invalid_argument if the axis is zero or anything is not finite
inline Quat from_axis_angle(const Vec3& axis, double angle) {
  require(std::isfinite(angle), "from_axis_angle: the angle is ", angle);
  require(axis.allFinite() && !axis.isZero(0), "from_axis_angle: the axis (", axis.transpose(),
          ") has no direction");
  Quat q;
  q.w() = std::cos(angle / 2);
  q.vec() = std::sin(angle / 2) * axis.stableNormalized();
  return q;
}

/// @}

}  // namespace tumble
