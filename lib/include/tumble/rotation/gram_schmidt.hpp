#pragma once
/// @file
/// Re-orthogonalisation by Gram–Schmidt: cheapest to understand, but the first column is never
/// moved and the last takes all the blame.

#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"

namespace tumble::rotation {

/// @addtogroup rotation
/// @{

/// A rotation near M: x = m₁/|m₁|, y = the part of m₂ perpendicular to x, normalised, z = x × y.
/// @param M 3×3 with columns m₁, m₂, m₃ that have drifted from a rotation's
/// @throws std::invalid_argument if M is not finite, its columns are dependent or left-handed
/// Source: Golub & Van Loan, "Matrix Computations" (2013), §5.2.
inline Mat3 gram_schmidt(const Mat3& M) {
  require(M.allFinite() && M.determinant() > 0,
          "gram_schmidt: not near a rotation, det M = ", M.determinant(),
          " must be positive; M =\n", M);
  const Vec3 x = M.col(0).normalized();
  const Vec3 y = (M.col(1) - x.dot(M.col(1)) * x).normalized();
  Mat3 R;
  R << x, y, x.cross(y);
  return R;
}

/// @}

}  // namespace tumble::rotation
