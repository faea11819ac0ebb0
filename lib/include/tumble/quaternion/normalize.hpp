#pragma once
/// @file
/// Keeping a quaternion a rotation: the whole repair that integration needs is one division.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"

namespace tumble::rotation {

/// @addtogroup quaternion
/// @{

/// |q| − 1: how far integration has let a unit quaternion drift.
template <class T>
T norm_drift(const Quaternion<T>& q) {
  return q.norm() - T(1);
}

/// q / |q|.
/// @throws std::invalid_argument if q is zero or not finite: it stands for no rotation
inline Quat normalize(const Quat& q) {
  const double norm = q.coeffs().stableNorm();
  require(norm > 0 && std::isfinite(norm), "no rotation has the quaternion (w x y z) = (", q.w(),
          ' ', q.x(), ' ', q.y(), ' ', q.z(), ")");
  return Quat(Eigen::Vector4d(q.coeffs() / norm));
}

/// @}

}  // namespace tumble::rotation

namespace tumble::detail {

/// The same orientation by numbers of about 1, to the last digit.
inline Quat of_moderate_length(const Quat& q) {
  const int exponent = std::ilogb(q.coeffs().cwiseAbs().maxCoeff());
  Quat scaled;
  for (int i = 0; i < 4; ++i) scaled.coeffs()[i] = std::scalbn(q.coeffs()[i], -exponent);
  return scaled;
}

}  // namespace tumble::detail
