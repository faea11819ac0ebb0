#pragma once
/// @file
/// A closed mesh as a sum of signed tetrahedra, one on each triangle of its faces: what one brings.
///
/// With the corners a, b, c about a reference point, 6V = ((b − a) × (c − a)) · a and s = a + b +
/// c: ∫ r dV = 6V/24 s,  ∫ r rᵀ dV = 6V/120 (s sᵀ + a aᵀ + b bᵀ + c cᵀ). Source: e.g. Blow &
/// Binstock, "How to find the inertia tensor (or other mass properties) of a 3D solid body
/// represented by a triangle mesh" (2004). Edges before the cross product and a reference point in
/// the middle are what keeps the digits.

#include "tumble/mass/moments.hpp"
#include "tumble/simd/point.hpp"

namespace tumble::detail {

using simd::Fma;

/// s t + a b + c d + e f
template <Fma fma, class T>
TUMBLE_INLINE T sum_of_products(const T& s, const T& t, const T& a, const T& b, const T& c,
                                const T& d, const T& e, const T& f) {
  return multiply_add<fma>(s, t, multiply_add<fma>(a, b, multiply_add<fma>(c, d, e * f)));
}

/// The moments of a signed tetrahedron without their factors: 6 ∫ dV, 24 ∫ r dV, 120 ∫ r rᵀ dV.
/// @param v its 6V; the corners a, b, c and the apex as in simd::six_volume()
template <Fma fma = simd::baseline_fma, class T>
TUMBLE_INLINE Moments<T> raw_moments(const T& v, const simd::Point<T>& a, const simd::Point<T>& b,
                                     const simd::Point<T>& c) {
  const T sx = a.x + b.x + c.x, sy = a.y + b.y + c.y, sz = a.z + b.z + c.z;
  return {v,
          v * sx,
          v * sy,
          v * sz,
          v * sum_of_products<fma>(sx, sx, a.x, a.x, b.x, b.x, c.x, c.x),
          v * sum_of_products<fma>(sy, sy, a.y, a.y, b.y, b.y, c.y, c.y),
          v * sum_of_products<fma>(sz, sz, a.z, a.z, b.z, b.z, c.z, c.z),
          v * sum_of_products<fma>(sx, sy, a.x, a.y, b.x, b.y, c.x, c.y),
          v * sum_of_products<fma>(sy, sz, a.y, a.z, b.y, b.z, c.y, c.z),
          v * sum_of_products<fma>(sz, sx, a.z, a.x, b.z, b.x, c.z, c.x)};
}

/// The moments from sums of raw_moments().
Moments<simd::DoubleDouble> with_factors(Moments<simd::DoubleDouble> m);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mass/tetrahedron.inl"
#endif
