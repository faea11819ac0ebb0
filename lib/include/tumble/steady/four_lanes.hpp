#pragma once
/// @file
/// A vector in four lanes, and its components in other orders: what cross products are made of.

#include <cmath>
#include <limits>

#include "tumble/core/largest.hpp"
#include "tumble/core/types.hpp"
#include "tumble/simd/pack.hpp"

namespace tumble::detail {

using simd::FourDoubles;

/// (x, y, z, 0).
TUMBLE_INLINE FourDoubles four_lanes(const Vec3& v) { return FourDoubles{v.x(), v.y(), v.z(), 0}; }

/// The length of all four lanes together. Squares would underflow where the lanes do not.
inline double norm(const FourDoubles& x) {
  const double most = largest({std::abs(x[0]), std::abs(x[1]), std::abs(x[2]), std::abs(x[3])});
  if (!(most > 0) || most > std::numeric_limits<double>::max()) return most;
  const FourDoubles y = x / most;
  return most * std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]);
}

/// (y, z, x, 0).
TUMBLE_INLINE FourDoubles yzx(const FourDoubles& a) {
  return __builtin_shufflevector(a, a, 1, 2, 0, 3);
}

/// (z, x, y, 0).
TUMBLE_INLINE FourDoubles zxy(const FourDoubles& a) {
  return __builtin_shufflevector(a, a, 2, 0, 1, 3);
}

}  // namespace tumble::detail
