#pragma once

#include "tumble/rotation/newton_rotation.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::detail {

TUMBLE_BODY Mat3 inverse_transpose(const Mat3& X) {
  Mat3 C;
  C << X.col(1).cross(X.col(2)), X.col(2).cross(X.col(0)), X.col(0).cross(X.col(1));
  const double det = X.col(0).dot(C.col(0));
  require(det > 0 && std::isfinite(det), "not near a rotation: det = ", det,
          " must be positive; the matrix is\n", X);
  return C / det;
}

}  // namespace tumble::detail

namespace tumble::rotation {

TUMBLE_BODY Mat3 newton_rotation(const Mat3& M) {
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

}  // namespace tumble::rotation
