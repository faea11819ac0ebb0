#pragma once

#include "tumble/rotation/gram_schmidt.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::rotation {

TUMBLE_BODY Mat3 gram_schmidt(const Mat3& M) {
  require(M.allFinite() && M.determinant() > 0,
          "gram_schmidt: not near a rotation, det M = ", M.determinant(),
          " must be positive; M =\n", M);
  const Vec3 x = M.col(0).normalized();
  const Vec3 y = (M.col(1) - x.dot(M.col(1)) * x).normalized();
  Mat3 R;
  R << x, y, x.cross(y);
  return R;
}

}  // namespace tumble::rotation
