#pragma once
/// @file
/// Exact mass properties of a polyhedron after Mirtich: volume → faces → shadows → edges.
///
/// Faces may be polygons of any shape, also concave. Everything is taken about the centre of the
/// mesh's bounding box, so that a body far from the origin loses no digits.
/// Source: Mirtich, "Fast and Accurate Computation of Polyhedral Mass Properties", JGT 1(2), 1996.

#include "tumble/mass/error_bound.hpp"
#include "tumble/mass/mirtich/volume_integrals.hpp"
#include "tumble/mesh/reference_point.hpp"

namespace tumble {

/// Mass properties of a mesh that is known to be closed; nothing is checked.
/// @param density [kg/m³]
inline BoundedMassProperties unchecked_mirtich(const PolygonMesh& mesh, double density) {
  const Vec3 p = reference_point(mesh);
  RoundingSums<double> rounding;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3& a = mesh.vertex(t[0]);
    rounding.add((a - p).lpNorm<1>(), (mesh.vertex(t[1]) - a).lpNorm<1>(),
                 (mesh.vertex(t[2]) - a).lpNorm<1>());
  });
  return bounded(mirtich::volume_integrals(mesh, p), p, density, 0x1p-53, rounding);
}

}  // namespace tumble
