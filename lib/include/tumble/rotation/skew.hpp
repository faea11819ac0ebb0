#pragma once
/// @file
/// The cross product as a matrix: [v]× w = v × w.
///
/// Source: any text on rigid bodies; here after Murray, Li & Sastry, "A Mathematical Introduction
/// to Robotic Manipulation" (1994), eq. 2.4, where it is written v̂.

#include "tumble/core/types.hpp"

namespace tumble::rotation {

/// @addtogroup rotation
/// @{

/// The skew-symmetric matrix [v]× with [v]× w = v × w for every w.
/// @param v 3-vector, any unit
/// @return 3×3, the unit of v
template <class T>
Matrix3<T> skew(const Vector3<T>& v) {
  Matrix3<T> m;
  // clang-format off
  m << T(0), -v.z(),  v.y(),
      v.z(),   T(0), -v.x(),
     -v.y(),  v.x(),   T(0);
  // clang-format on
  return m;
}

/// The vector v of the skew-symmetric part of M: the inverse of skew() where M is skew-symmetric.
/// @param M 3×3; its symmetric part is ignored
template <class T>
Vector3<T> unskew(const Matrix3<T>& M) {
  return Vector3<T>(M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1)) / T(2);
}

/// @}

}  // namespace tumble::rotation
