#pragma once
/// @file
/// The matrices that the specs of this chapter try, and how badly conditioned they are.

#include <Eigen/LU>
#include <Eigen/SVD>

#include "judge/spec/inputs.hpp"

namespace tumble::judge {

/// A matrix whose numbers are off those of a rotation by up to `size` ≤ 0.4, of positive
/// determinant.
inline Mat3 drifted_rotation(double size) {
  constexpr double far_from_singular = 0.2;
  for (;;) {
    Mat3 M = any_rotation();
    for (int j = 0; j < 3; ++j) M.col(j) += any_vector(size);
    if (M.determinant() > far_from_singular) return M;
  }
}

/// R after `steps` Euler steps of Ṙ = ω × R: each one stretches what is across ω.
inline Mat3 drifted_by_euler(Mat3 R, const Vec3& omega, double h, int steps) {
  for (int n = 0; n < steps; ++n)
    for (int j = 0; j < 3; ++j) R.col(j) += h * omega.cross(R.col(j));
  return R;
}

/// The condition number: by how much M enlarges relative errors at worst, in ‖·‖₂.
inline double condition(const Mat3& M) {
  const Vec3 stretch = Eigen::JacobiSVD<Mat3>(M).singularValues();
  return stretch[0] / stretch[2];
}

}  // namespace tumble::judge
