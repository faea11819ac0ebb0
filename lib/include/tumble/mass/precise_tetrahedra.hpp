#pragma once
/// @file
/// Mass properties of a closed mesh to the last bit, also for plates and needles that lie askew.
///
/// Where tetrahedra are thin, ((b − a) × (c − a)) · a cancels: only that volume is computed with
/// the exact products and differences of double_double.hpp; the weights (corners) are plain
/// doubles. Source: Ogita, Rump & Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput.
/// 26(6), 2005, for products and sums that carry their errors along.

#include "tumble/mass/tetrahedra.hpp"

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

/// Mass properties of a closed mesh: the mass to the last bit on every shape; the
/// inertia too, unless the tetrahedra cancel (a plate with the reference point beside
/// it), which its bound shows. Three times slower than fast_tetrahedra(). Nothing is
/// checked: see mesh_mass_properties().
/// @param mesh    closed, faces counter-clockwise seen from outside
/// @param density [kg/m³]
inline BoundedMassProperties precise_tetrahedra(const PolygonMesh& mesh, double density) {
  const Vec3 p = reference_point(mesh);
  DoubleDouble volume;
  RoundingSums rounding;
  double weights = 0;
  const auto term = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const DoubleDouble v = precise_six_volume(a, b, c, p);
    volume += v;
    rounding.add(a - p, b - a, c - a);
    const Moments<double> raw = raw_moments<double>(v.hi + v.lo, a - p, b - p, c - p);
    weights += std::abs(raw.xx + raw.yy + raw.zz);
    return raw;
  };
  Moments<DoubleDouble> sum = sum_over_triangles(mesh, term);
  sum.one = volume;
  return bounded(with_factors(sum), p, density, 0x1p-104, rounding, 4 * 0x1p-53 * weights);
}

}  // namespace tumble
