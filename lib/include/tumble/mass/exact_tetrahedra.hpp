#pragma once
/// @file
/// Mass properties of a closed mesh in double-double: about 28 digits, the exact value for all that
/// a double can show. Twenty times slower than fast_tetrahedra(); what the others are measured by.

#include "tumble/mass/tetrahedra.hpp"

namespace tumble {

/// The moments of a closed mesh about a point, with everything in double-double.
/// Nothing is checked.
/// @param reference near the body [m]
inline Moments<DoubleDouble> exact_moments(const PolygonMesh& mesh, const Vec3& reference) {
  const Vector3<DoubleDouble> p = reference.cast<DoubleDouble>();
  const auto corner = [&](int v) -> Vector3<DoubleDouble> {
    return mesh.vertex(v).cast<DoubleDouble>() - p;
  };
  Moments<DoubleDouble> sum;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vector3<DoubleDouble> a = corner(t[0]), b = corner(t[1]), c = corner(t[2]);
    sum += raw_moments<DoubleDouble>(six_volume<DoubleDouble>(a, b, c), a, b, c);
  });
  return with_factors(sum);
}

/// Mass properties of a closed mesh, each number the true one rounded to double.
/// Nothing is checked.
/// @param density [kg/m³]
inline BoundedMassProperties exact_tetrahedra(const PolygonMesh& mesh, double density) {
  const Vec3 p = reference_point(mesh);
  RoundingSums rounding;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3& a = mesh.vertex(t[0]);
    rounding.add(a - p, mesh.vertex(t[1]) - a, mesh.vertex(t[2]) - a);
  });
  return bounded(exact_moments(mesh, p), p, density, 0x1p-104, rounding);
}

}  // namespace tumble
