#pragma once
/// @file
/// The volume of a tetrahedron to the last bit, also of one so thin that doubles cancel.
///
/// ((b − a) × (c − a)) · (a − p) with the exact products and differences of double_double.hpp.
/// Source: Ogita, Rump & Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26(6), 2005,
/// for products and sums that carry their errors along.

#include <array>

#include "tumble/core/double_double.hpp"
#include "tumble/core/types.hpp"

namespace tumble {

/// x·y − z·w to about twice the digits of double, hi and lo not normalised.
inline DoubleDouble product_difference(const DoubleDouble& x, const DoubleDouble& y,
                                       const DoubleDouble& z, const DoubleDouble& w) {
  const DoubleDouble p = two_prod(x.hi, y.hi), q = two_prod(z.hi, w.hi);
  const DoubleDouble s = two_diff(p.hi, q.hi);
  const double rest = (x.hi * y.lo + x.lo * y.hi) - (z.hi * w.lo + z.lo * w.hi);
  return {s.hi, s.lo + ((p.lo - q.lo) + rest)};
}

/// u · v to about twice the digits of double.
inline DoubleDouble precise_dot(const std::array<DoubleDouble, 3>& u,
                                const std::array<DoubleDouble, 3>& v) {
  DoubleDouble sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleDouble p = two_prod(u[i].hi, v[i].hi), s = two_sum(sum.hi, p.hi);
    sum = {s.hi, sum.lo + (s.lo + (p.lo + (u[i].hi * v[i].lo + u[i].lo * v[i].hi)))};
  }
  return sum;
}

/// a − b exactly, coordinate by coordinate.
inline std::array<DoubleDouble, 3> exact_difference(const Vec3& a, const Vec3& b) {
  return {two_diff(a[0], b[0]), two_diff(a[1], b[1]), two_diff(a[2], b[2])};
}

/// 6V of the tetrahedron on the triangle a, b, c with apex p, to about 2⁻¹⁰⁴ |e|₁ |f|₁ |a − p|₁
/// [m³].
inline DoubleDouble precise_six_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const auto e = exact_difference(b, a), f = exact_difference(c, a);
  return precise_dot(
      {product_difference(e[1], f[2], e[2], f[1]), product_difference(e[2], f[0], e[0], f[2]),
       product_difference(e[0], f[1], e[1], f[0])},
      exact_difference(a, p));
}

}  // namespace tumble
