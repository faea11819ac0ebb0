#pragma once
/// @file
/// How far a matrix is from being a rotation: its columns must be orthogonal
/// unit vectors, right-handed.

#include "tumble/core/types.hpp"

namespace tumble::rotation {

/// @addtogroup rotation
/// @{

/// ‖MᵀM − 1‖ (Frobenius): 0 for a rotation or a reflection, about twice the relative
/// stretch or shear.
inline double orthonormality_error(const Mat3& M) {
  return (M.transpose() * M - Mat3::Identity()).norm();
}

/// Whether M is a rotation matrix to within `tolerance` of orthonormality_error(); false for NaN.
inline bool is_rotation(const Mat3& M, double tolerance) {
  return orthonormality_error(M) <= tolerance && M.determinant() > 0;
}

/// @}

}  // namespace tumble::rotation
