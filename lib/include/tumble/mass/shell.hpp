#pragma once
/// @file
/// Mass properties of a thin shell: the mass lies in the surface itself, so much a square metre.
///
/// For a triangle with the corners a, b, c and the area A: ∫ r dA = A/3 (a + b + c), ∫ r rᵀ dA =
/// A/12 (s sᵀ + a aᵀ + b bᵀ + c cᵀ), s = a + b + c. Source: e.g. Eberly, "Polyhedral mass
/// properties (revisited)" (2002), one dimension lower; it is the midpoint rule of order 2.

#include "tumble/mass/moments.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::shells {

/// @addtogroup mass
/// @{

/// The area of the surface [m²]: of all triangles, both sides of what is there twice.
/// @param mesh indices in range, positions finite
double area(const PolygonMesh& mesh);

/// Mass, centre of mass and inertia of a thin shell. The surface may be open, and need not be
/// oriented.
/// @param mesh            faces [m]
/// @param surface_density mass of a unit of area [kg/m²]: density times thickness
/// @throws std::invalid_argument if the surface density is not positive and finite, or the mesh has
///         an index out of range, a position that is not finite, no area, or one that is too small
///         or too large for its inertia to be a double
MassProperties mass_properties(const PolygonMesh& mesh, double surface_density);

/// @}

}  // namespace tumble::shells

#ifndef TUMBLE_COMPILED
#include "tumble/mass/shell.inl"
#endif
