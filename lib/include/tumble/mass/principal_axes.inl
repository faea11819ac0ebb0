#pragma once

#include "tumble/core/rounding.hpp"
#include "tumble/mass/principal_axes.hpp"

#include <cmath>
#include <utility>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY void jacobi_rotation(Mat3& A, Mat3& R, int i, int j) {
  const double a = A(i, j);
  // Below the rounding of its row and column it says nothing: turning would only add errors to R.
  const double size = std::sqrt(std::abs(A(i, i))) * std::sqrt(std::abs(A(j, j)));  // in range
  if (std::abs(a) <= unit_roundoff * size) return;
  const double theta = (A(j, j) - A(i, i)) / (2 * a);
  const double t = std::copysign(1, theta) / (std::abs(theta) + std::hypot(theta, 1));
  const Eigen::JacobiRotation<double> turn(1 / std::hypot(t, 1), t / std::hypot(t, 1));
  const int k = 3 - i - j;
  // A'(i, i) = A(i, i) − t a, A'(j, j) = A(j, j) + t a: small moments are not formed
  // from large ones.
  A(i, i) -= t * a;
  A(j, j) += t * a;
  A(i, j) = A(j, i) = 0;
  const double p = A(i, k), q = A(j, k);
  A(i, k) = A(k, i) = turn.c() * p - turn.s() * q;
  A(j, k) = A(k, j) = turn.s() * p + turn.c() * q;
  R.applyOnTheRight(i, j, turn);
}

}  // namespace tumble::detail

namespace tumble {

TUMBLE_BODY PrincipalAxes principal_axes(const Mat3& I) {
  Mat3 A = (I + I.transpose()) / 2;
  Mat3 R = Mat3::Identity();
  // Converges quadratically: 5 sweeps reach the last bit, entries below it no longer matter.
  for (int sweep = 0; sweep < 8; ++sweep) {
    detail::jacobi_rotation(A, R, 0, 1);
    detail::jacobi_rotation(A, R, 0, 2);
    detail::jacobi_rotation(A, R, 1, 2);
  }
  for (const auto& [i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}}) {
    if (A(i, i) <= A(j, j)) continue;
    std::swap(A(i, i), A(j, j));
    R.col(i).swap(R.col(j));
  }
  if (R.determinant() < 0) R.col(2) = -R.col(2);
  return {A.diagonal(), R};
}

}  // namespace tumble
