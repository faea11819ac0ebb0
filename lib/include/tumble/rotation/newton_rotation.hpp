#pragma once
/// @file
/// Re-orthogonalisation by Newton's iteration: the same nearest rotation, without an SVD.
///
/// X ← ½ (X + X⁻ᵀ) squares the distance to the polar factor at each step, so that one step mends
/// what an integrator's step has done.
///
/// Source: Higham, "Computing the polar decomposition", SIAM J. Sci. Stat. Comput. 7
/// (1986), eq. 3.1.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"

namespace tumble::detail {

/// X⁻ᵀ from cross products: its columns are x₂ × x₃, x₃ × x₁, x₁ × x₂ over det X.
/// @throws std::invalid_argument unless det X is positive and finite
inline Mat3 inverse_transpose(const Mat3& X) {
  Mat3 C;
  C << X.col(1).cross(X.col(2)), X.col(2).cross(X.col(0)), X.col(0).cross(X.col(1));
  const double det = X.col(0).dot(C.col(0));
  require(det > 0 && std::isfinite(det), "not near a rotation: det = ", det,
          " must be positive; the matrix is\n", X);
  return C / det;
}

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
inline Mat3 newton_rotation(const Mat3& M) {
  constexpr double converged = 1e-8;  // what is left is about the square of this change: below eps
  constexpr int max_iterations = 20;  // a cap that scaled steps do not come near
  Mat3 X = M;
  for (int i = 0; i < max_iterations; ++i) {
    const Mat3 Y = detail::inverse_transpose(X);
    const double gamma = std::sqrt(Y.norm() / X.norm());
    const Mat3 next = (gamma * X + Y / gamma) / 2;
    const double change = (next - X).norm();
    X = next;
    if (change <= converged) break;
  }
  return X;
}

/// @}

}  // namespace tumble::rotation
