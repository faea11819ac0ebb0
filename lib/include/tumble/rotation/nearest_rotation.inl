#pragma once

#include "tumble/core/rounding.hpp"
#include "tumble/rotation/nearest_rotation.hpp"

#include <Eigen/SVD>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble {

TUMBLE_BODY Mat3 nearest_rotation(const Mat3& M) {
  require(M.allFinite(), "nearest_rotation: matrix is not finite:\n", M);
  const Eigen::JacobiSVD<Mat3> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3& stretch = svd.singularValues();             // in falling order
  constexpr double rounding = 8 * detail::unit_roundoff;  // relative to the largest
  require(stretch[1] > rounding * stretch[0],
          "nearest_rotation: no rotation is nearest to a matrix ", "of rank ",
          stretch[0] > 0 ? 1 : 0, ":\n", M);
  const double turn = (svd.matrixU() * svd.matrixV().transpose()).determinant() > 0 ? 1 : -1;
  return svd.matrixU() * Vec3(1, 1, turn).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace tumble
