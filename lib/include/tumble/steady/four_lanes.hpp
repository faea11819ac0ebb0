#pragma once
/// @file
/// A vector in four lanes, and its components in other orders: what cross products are made of.

#include <cmath>

#include "tumble/core/types.hpp"
#include "tumble/simd/pack.hpp"

namespace tumble::detail {

using simd::FourDoubles;

/// (x, y, z, 0).
TUMBLE_INLINE FourDoubles four_lanes(const Vec3& v) { return FourDoubles{v.x(), v.y(), v.z(), 0}; }

/// The length of all four lanes together.
inline double norm(const FourDoubles& x) {
  return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
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
