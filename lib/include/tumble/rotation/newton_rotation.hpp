#pragma once
/// @file
/// Re-orthogonalisation by Newton's iteration: the same nearest rotation, without an SVD.
///
/// X ← ½ (X + X⁻ᵀ) squares the distance to the polar factor at each step, so that one step mends
/// what an integrator's step has done.
///
/// Source: Higham, "Computing the polar decomposition", SIAM J. Sci. Stat. Comput. 7
/// (1986), eq. 3.1.

#include "tumble/core/types.hpp"

namespace tumble::detail {

/// X⁻ᵀ from cross products: its columns are x₂ × x₃, x₃ × x₁, x₁ × x₂ over det X.
/// @throws std::invalid_argument unless det X is positive and finite
Mat3 inverse_transpose(const Mat3& X);

}  // namespace tumble::detail

namespace tumble::rotation {

/// @addtogroup rotation
/// @{

/// One Newton step towards the nearest rotation: an orthonormality error e becomes about e²/4.
/// @throws std::invalid_argument unless det M is positive and finite
inline Mat3 newton_rotation_step(const Mat3& M) { return (M + detail::inverse_transpose(M)) / 2; }

/// The nearest rotation, by Newton steps until they change nothing.
/// @param M any 3×3 matrix with a positive determinant; scaled steps (Higham's γ) bring even a
///          badly stretched one home in about ten
/// @throws std::invalid_argument unless det M is positive and finite
Mat3 newton_rotation(const Mat3& M);

/// @}

}  // namespace tumble::rotation

#ifndef TUMBLE_COMPILED
#include "tumble/rotation/newton_rotation.inl"
#endif
