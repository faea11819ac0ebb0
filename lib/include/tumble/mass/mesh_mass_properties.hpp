#pragma once
/// @file
/// Mass properties of a mesh: the door to use.
///
/// First the mesh is diagnosed; then the integrals are computed as accurately as was asked for;
/// then the result is looked at.

#include <vector>

#include "tumble/mass/error_bound.hpp"
#include "tumble/mass/mass_properties.hpp"
#include "tumble/mesh/diagnose.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// How the integrals over a mesh are computed.
enum class Accuracy {
  fast,      ///< doubles, many triangles at once: 1e-15 for ordinary shapes, see the bounds
  tight,     ///< pairs of doubles: right to the last bit for every shape, 3 to 4 times as long
  textbook,  ///< Mirtich's way over faces, shadows and edges: 1e-14, some 20 times as long
};

/// What to compute, and how.
struct MassOptions {
  Accuracy accuracy = Accuracy::tight;
  Policy policy = Policy::refuse;
  simd::LoopOptions loop = {};
  double tolerance = 1e-6;  ///< the share of the volume that may count wrongly at a crossing
  crossings::Search search = crossings::Search::usual;
};

namespace detail {

/// The integrals over a mesh, and what rounding may have done to them.
struct MeshIntegrals {
  Moments<simd::DoubleDouble> moments;
  Vec3 reference;  ///< the point that they are about [m]
  IntegralErrors errors;

  BoundedMassProperties at(double density) const {
    return bounded(moments, reference, density, errors);
  }
};

/// @param mesh as unchecked_mass_properties() wants it
MeshIntegrals integrals_over(const PolygonMesh& mesh, Accuracy accuracy,
                             const simd::LoopOptions& loop);

}  // namespace detail

/// Mass properties of a mesh that is known to be closed; nothing is checked. A face that is not
/// plane counts as the fan of triangles from its first corner.
/// @param mesh    indices in range; faces counter-clockwise seen from outside [m]
/// @param density [kg/m³]
inline BoundedMassProperties unchecked_mass_properties(const PolygonMesh& mesh, double density,
                                                       Accuracy accuracy = Accuracy::tight,
                                                       const simd::LoopOptions& loop = {}) {
  return detail::integrals_over(mesh, accuracy, loop).at(density);
}

/// Mass properties of a mesh, and everything that was found about it.
struct MeshMassProperties : BoundedMassProperties {
  std::vector<MeshDefect> findings;  ///< of diagnose(); with Policy::refuse nothing that spoils
};

/// Mass, centre of mass and inertia of the body that a mesh encloses, with bounds of their rounding
/// errors. A face that is not plane counts as the fan of triangles from its first corner.
/// @param mesh    closed, faces counter-clockwise seen from outside [m]
/// @param density the same everywhere [kg/m³]
/// @throws std::invalid_argument if the density is not positive and finite; with Policy::refuse
///         also if the mesh is not the boundary of a body, is inside out, or encloses no volume,
///         and with Policy::accept if there is nothing to integrate over (no faces, vertices that
///         do not exist or are not finite); the message says what and where
MeshMassProperties mesh_mass_properties(const PolygonMesh& mesh, double density,
                                        const MassOptions& options = {});

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/mesh_mass_properties.inl"
#endif
