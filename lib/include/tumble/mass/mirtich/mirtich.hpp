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

namespace tumble::detail {

/// Bounds of the rounding errors of volume_integrals(). An integral over a shadow is a
/// sum over edges of terms up to |edge| |x|ᵏ, whose difference is as small as the shadow: with the
/// perimeter l and the farthest corner R of a face, a few eps l R² of its part of the volume are
/// lost, l R³ of the first and l R⁴ of the second moments. (Tetrahedra lose eps |e| |f| R: less,
/// the smaller the faces are.)
inline IntegralErrors mirtich_errors(const PolygonMesh& mesh, const Vec3& reference) {
  IntegralErrors errors{};
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    double l = 0, R = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec3 &x = mesh.vertex(face[k]),
                 &next = mesh.vertex(face[k + 1 < face.size() ? k + 1 : 0]);
      l += (next - x).lpNorm<1>();
      R = std::max(R, (x - reference).lpNorm<1>());
    }
    const double lost = unit_roundoff / 2 * l * R * R;  // ten times the largest seen
    errors.volume += lost;
    errors.first += lost * R;
    errors.second += lost * R * R;
  }
  return errors;
}

/// Mass properties of a mesh that is known to be closed; nothing is checked.
/// @param density [kg/m³]
inline BoundedMassProperties unchecked_mirtich(const PolygonMesh& mesh, double density) {
  const Vec3 p = reference_point(mesh);
  return bounded(mirtich::volume_integrals(mesh, p), p, density, mirtich_errors(mesh, p));
}

}  // namespace tumble::detail
