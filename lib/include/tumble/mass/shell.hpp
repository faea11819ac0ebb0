#pragma once
/// @file
/// Mass properties of a thin shell: the mass lies in the surface itself, so much a square metre.
///
/// For a triangle with the corners a, b, c and the area A: ∫ r dA = A/3 (a + b + c), ∫ r rᵀ dA =
/// A/12 (s sᵀ + a aᵀ + b bᵀ + c cᵀ), s = a + b + c. Source: e.g. Eberly, "Polyhedral mass
/// properties (revisited)" (2002), one dimension lower; it is the midpoint rule of order 2.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/mass/moments.hpp"
#include "tumble/mass/require_volume.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/reference_point.hpp"

namespace tumble::shells {

/// @addtogroup mass
/// @{

/// The area of the surface [m²]: of all triangles, both sides of what is there twice.
/// @param mesh indices in range, positions finite
inline double area(const PolygonMesh& mesh) {
  simd::DoubleDouble sum;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3& a = mesh.vertex(t[0]);
    sum += (mesh.vertex(t[1]) - a).cross(mesh.vertex(t[2]) - a).norm() / 2;
  });
  return double(sum);
}

/// Mass, centre of mass and inertia of a thin shell. The surface may be open, and need not be
/// oriented.
/// @param mesh            faces [m]
/// @param surface_density mass of a unit of area [kg/m²]: density times thickness
/// @throws std::invalid_argument if the surface density is not positive and finite, or the mesh has
///         an index out of range, a position that is not finite, no area, or one that is too small
///         or too large for its inertia to be a double
inline MassProperties mass_properties(const PolygonMesh& mesh, double surface_density) {
  require(surface_density > 0 && std::isfinite(surface_density), "the surface density ",
          surface_density, " kg/m² is not positive and finite");
  for (const auto& find : {detail::find_bad_indices, detail::find_not_finite})
    for (const MeshDefect& finding : find(mesh)) require(false, finding.message);
  const Vec3 p = detail::reference_point(mesh);
  detail::BlockedMoments sum;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3 a = mesh.vertex(t[0]) - p, b = mesh.vertex(t[1]) - p, c = mesh.vertex(t[2]) - p;
    const double A = (mesh.vertex(t[1]) - mesh.vertex(t[0]))
                         .cross(mesh.vertex(t[2]) - mesh.vertex(t[0]))
                         .norm() /
                     2;
    const Vec3 s = a + b + c, first = A / 3 * s;
    const Mat3 second =
        A / 12 * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    sum.add({A, first.x(), first.y(), first.z(), second(0, 0), second(1, 1), second(2, 2),
             second(0, 1), second(1, 2), second(2, 0)});
  });
  const Moments<simd::DoubleDouble> total = sum.total();
  require(double(total.one) > 0 && std::isfinite(double(total.one)),
          "the surface has no area: there is no shell");
  // Digits that the integrals don't have come with no density.
  detail::require_normal(tumble::mass_properties(total, p, 1), "shell");
  MassProperties shell = tumble::mass_properties(total, p, surface_density);
  detail::require_normal(shell, "shell");
  return shell;
}

/// @}

}  // namespace tumble::shells
