#pragma once
/// @file
/// Mass properties of a mesh: the door to use.
///
/// First the mesh is diagnosed; then the integrals are sums over signed tetrahedra with volumes to
/// the last bit (precise_tetrahedra()); where the bound says that this lost digits of the inertia,
/// all is done again in double-double (exact_tetrahedra()); then the result is looked at.

#include "tumble/mass/closed_mesh.hpp"
#include "tumble/mass/exact_tetrahedra.hpp"
#include "tumble/mass/precise_tetrahedra.hpp"

namespace tumble {

/// Mass properties of a mesh that is known to be closed; nothing is checked.
/// @param density [kg/m³]
inline BoundedMassProperties unchecked_mass_properties(const PolygonMesh& mesh, double density) {
  constexpr double good_enough =
      64 * 0x1p-53;  // errors are a tenth of the bound: still the last digit
  const BoundedMassProperties body = precise_tetrahedra(mesh, density);
  return body.inertia_error_bound <= good_enough ? body : exact_tetrahedra(mesh, density);
}

/// Mass, centre of mass and inertia of the body that a mesh encloses, with bounds of their rounding
/// errors. A face that is not plane counts as the fan of triangles from its first corner.
/// @param mesh    closed, faces counter-clockwise seen from outside [m]
/// @param density the same everywhere [kg/m³]
/// @throws std::invalid_argument if the density is not positive and finite, the mesh is not the
///         boundary of a body, is inside out, or encloses no volume; the message says what and
///         where
inline BoundedMassProperties mesh_mass_properties(const PolygonMesh& mesh, double density) {
  require_measurable(mesh, density);
  return require_volume(unchecked_mass_properties(mesh, density));
}

}  // namespace tumble
