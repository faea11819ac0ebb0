#pragma once
/// @file
/// The quaternion functions of the library on the four numbers (w, x, y, z) of the exercises.
#include "tumble/quaternion/convert.hpp"
#include "tumble/quaternion/quaternion_dot.hpp"
#include "tumble/quaternion/slerp.hpp"

namespace reference {

using Quaternion = Eigen::Vector4d;
using tumble::coefficients;
using tumble::from_coefficients;
using tumble::Mat3;
using tumble::Vec3;

inline const Quaternion one(1, 0, 0, 0), i(0, 1, 0, 0), j(0, 0, 1, 0), k(0, 0, 0, 1);

inline Quaternion product(const Quaternion& a, const Quaternion& b) {
  return coefficients(from_coefficients(a) * from_coefficients(b));
}

inline Quaternion conjugate(const Quaternion& q) {
  return coefficients(from_coefficients(q).conjugate());
}

inline Quaternion inverse(const Quaternion& q) {
  return coefficients(from_coefficients(q).inverse());
}

inline Mat3 to_matrix(const Quaternion& q) { return tumble::to_matrix(from_coefficients(q)); }

inline Quaternion from_matrix(const Mat3& R) { return coefficients(tumble::from_matrix(R)); }

inline Vec3 rotate(const Quaternion& q, const Vec3& p) { return to_matrix(q) * p; }

inline Quaternion from_axis_angle(const Vec3& axis, double angle) {
  return coefficients(tumble::from_axis_angle(axis, angle));
}

inline Quaternion slerp(const Quaternion& a, const Quaternion& b, double t) {
  return coefficients(tumble::slerp(from_coefficients(a), from_coefficients(b), t));
}

inline Quaternion quaternion_dot(const Quaternion& q, const Vec3& omega) {
  return coefficients(tumble::rotation::quaternion_dot(from_coefficients(q), omega));
}

/// How a quaternion is read, and stored, by someone who believes that the scalar comes last.
inline Quaternion read_scalar_last(const Quaternion& q) { return {q[3], q[0], q[1], q[2]}; }
inline Quaternion store_scalar_last(const Quaternion& q) { return {q[1], q[2], q[3], q[0]}; }

}  // namespace reference
