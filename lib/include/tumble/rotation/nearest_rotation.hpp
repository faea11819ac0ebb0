#pragma once
/// @file
/// Re-orthogonalisation by the polar decomposition: the rotation nearest to M, no column favoured.
///
/// M = R S with S symmetric; from the singular value decomposition M = U Σ Vᵀ, R = U Vᵀ, with the
/// sign of the last singular direction turned where that would be a reflection.
///
/// Source: Higham, "Functions of Matrices" (2008), ch. 8; the sign: Umeyama, IEEE PAMI 13
/// (1991), eq. 43.

#include <Eigen/SVD>

#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup rotation
/// @{

/// The rotation R that minimises ‖R − M‖ (Frobenius).
/// @param M any 3×3 matrix of rank 2 or 3
/// @throws std::invalid_argument if M is not finite or of rank < 2: no rotation is nearest then
inline Mat3 nearest_rotation(const Mat3& M) {
  require(M.allFinite(), "nearest_rotation: matrix is not finite:\n", M);
  const Eigen::JacobiSVD<Mat3> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3& stretch = svd.singularValues();  // in falling order
  constexpr double rounding = 4 * 0x1p-52;     // relative to the largest
  require(stretch[1] > rounding * stretch[0],
          "nearest_rotation: no rotation is nearest to a matrix ", "of rank ",
          stretch[0] > 0 ? 1 : 0, ":\n", M);
  const double turn = (svd.matrixU() * svd.matrixV().transpose()).determinant() > 0 ? 1 : -1;
  return svd.matrixU() * Vec3(1, 1, turn).asDiagonal() * svd.matrixV().transpose();
}

/// @}

}  // namespace tumble
