#pragma once
/// @file
/// The axes about which a body turns without wobbling: I = R diag(A, B, C) Rᵀ, A ≤ B ≤ C.
///
/// Cyclic Jacobi rotations: for tensors of long or flat bodies they keep digits of the small moment
/// that reducing to tridiagonal form first would lose.
/// Source: Golub & Van Loan, "Matrix Computations" (4th ed. 2013), §8.5; Demmel & Veselić,
/// "Jacobi's method is more accurate than QR", SIAM J. Matrix Anal. Appl. 13(4), 1992.

#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// Principal moments and the rotation between principal and body axes.
struct PrincipalAxes {
  Vec3 moments;  ///< ascending [kg m²]
  Mat3 R;        ///< maps principal to body coordinates; columns are the axes; det R = +1
};

namespace detail {

/// Turns the plane of axes i and j of the symmetric A so that A(i, j) becomes 0; A = R A' Rᵀ.
void jacobi_rotation(Mat3& A, Mat3& R, int i, int j);

}  // namespace detail

/// Principal moments and axes of a symmetric tensor. Where moments are equal the axes between them
/// are not determined; those nearest to the given ones come out (a multiple of 1 gives R = 1).
/// @param I symmetric 3×3 [kg m²]; only the mean of I and Iᵀ matters
PrincipalAxes principal_axes(const Mat3& I);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/principal_axes.inl"
#endif
