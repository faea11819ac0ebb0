#pragma once
/// @file
/// The turn over a step in which the angular velocity is a power series: the Magnus series, whose
/// sum is a rotation vector. Wherever it is cut off, the turn is a rotation.
///
///   Ω = ∫ b ds + commutators of α₁, α₂, …, the coefficients of b about the middle of the step
///
/// About the middle half of the commutators vanish, and the others come from a few cross products.
/// Source: Blanes, Casas & Ros, "Improved high order integrators based on the Magnus expansion",
/// BIT 40 (2000) 434–450, §3. As ω is about the body's axes, their [A, B] is B × A here.

#include <cstddef>

#include "tumble/simd/point.hpp"

namespace tumble::detail::ensembles {

/// b[0] + w[0] b[1] + w[1] b[2] + …
template <std::size_t n, class P>
TUMBLE_INLINE simd::Point<P> weighted_sum(const simd::Point<P>* b, const double (&w)[n]) {
  simd::Point<P> sum = b[0];
#pragma GCC unroll 16
  for (std::size_t k = 0; k < n; ++k) sum = add_scaled(sum, w[k], b[k + 1]);
  return sum;
}

/// The rotation vector over a step, from order 4 of the series: Ω = M + (1/12) M × (b(1) − b(0)),
/// M = ∫ b ds.
template <class P>
TUMBLE_INLINE simd::Point<P> rotation_vector(const simd::Point<P> (&b)[5]) {
  const simd::Point<P> M = weighted_sum(b, {1. / 2, 1. / 3, 1. / 4});
  return add_cross(M, M, 1. / 12 * weighted_sum(b + 1, {1., 1., 1.}));
}

/// From order 6: their eq. 3.7. The weights are those of b about the middle; what would change Ω by
/// h⁷ only is left out.
template <class P>
TUMBLE_INLINE simd::Point<P> rotation_vector(const simd::Point<P> (&b)[7]) {
  using simd::Point;
  const Point<P> M = weighted_sum(b, {1. / 2, 1. / 3, 1. / 4, 1. / 5, 1. / 6});
  const Point<P> a1 = weighted_sum(b, {1. / 2, 1. / 4, 1. / 8});
  const Point<P> a2 = weighted_sum(b + 1, {1., 9. / 10, 4. / 5});
  const Point<P> a3 = weighted_sum(b + 2, {3. / 2});
  const Point<P> c = cross(a1, a2);
  const Point<P> x = add_scaled(1. / 12 * a1, 1. / 240, a3 + c);
  const Point<P> y = add_cross(a2, a1, add_scaled(1. / 30 * a3, -1. / 60, c));
  return add_cross(M, x, y);
}

/// From order 8: their eq. 3.9. The weights are those of the cubic that has the same moments
/// ∫ (s − ½)ⁱ b ds.
template <class P>
TUMBLE_INLINE simd::Point<P> rotation_vector(const simd::Point<P> (&b)[9]) {
  using simd::Point;
  const Point<P> M = weighted_sum(b, {1. / 2, 1. / 3, 1. / 4, 1. / 5, 1. / 6, 1. / 7, 1. / 8});
  const Point<P> a1 = weighted_sum(b, {1. / 2, 1. / 4, 1. / 8, 2. / 35, 1. / 56});
  const Point<P> a2 = weighted_sum(b + 1, {1., 3. / 4, 1. / 2, 25. / 84, 1. / 7});
  const Point<P> a3 = weighted_sum(b + 2, {3. / 2, 12. / 7, 25. / 14});
  const Point<P> a4 = weighted_sum(b + 3, {2., 25. / 9, 10. / 3});
  const Point<P> p = add_scaled(a1, 1. / 28, a3), r = add_scaled(a2, 3. / 28, a4);
  const Point<P> s1 = 1. / 28 * cross(p, r);
  const Point<P> r1 = -1. / 3 * cross(a1, add_scaled(s1, -1. / 14, a3));
  const Point<P> s2 = cross(r + r1, p + s1);
  const Point<P> s2_ = cross(s1, a2);
  const Point<P> r2 = cross(add_scaled(2. * a3 + s2, 1. / 2, s2_), add_scaled(a1, 5. / 4, s1));
  const Point<P> left =
      add_scaled(add_scaled(add_scaled(a1, 1. / 12, a3), -7. / 3, s1), -1. / 6, s2);
  const Point<P> right = add_scaled(add_scaled(add_scaled(r2, 63., r1), -9., a2), -9. / 4, a4);
  return add_cross(add_scaled(M, -7. / 120, s2), right, 1. / 360 * left);
}

}  // namespace tumble::detail::ensembles
