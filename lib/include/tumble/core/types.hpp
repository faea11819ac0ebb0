#pragma once
#if __cplusplus < 202002L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 202002L)
#error "tumble is written in C++20: compile with -std=c++20 or newer"
#endif
/// @file
/// The small fixed-size types that everything else is written in.
///
/// Conventions of the whole library, pinned by tests:
/// - a rotation R or q without a suffix maps body coordinates to world coordinates;
/// - a quaternion is written (w, x, y, z) in text, constructors and state vectors (Eigen keeps
///   (x, y, z, w) in `coeffs()`, which is an implementation detail here);
/// - products of inertia carry the minus sign: I_xy = −∫ x y dm;
/// - SI units unless a declaration says otherwise; angles in radians.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tumble {

/// @addtogroup core
/// @{

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
template <class T>
using Quaternion = Eigen::Quaternion<T>;

using Vec3 = Vector3<double>;
using Mat3 = Matrix3<double>;
using Quat = Quaternion<double>;

/// @}

}  // namespace tumble
