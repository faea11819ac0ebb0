#pragma once
/// @file
/// Mass properties of a closed mesh to the last bit, also for plates and needles that lie askew.
///
/// Where tetrahedra are thin their volumes cancel: only those are computed with twice the digits
/// (precise_volume.hpp); the weights (corners) are plain doubles.

#include "tumble/mass/tetrahedra.hpp"
#include "tumble/mesh/precise_volume.hpp"

namespace tumble {

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
