#pragma once
/// @file
/// Mass properties of a mesh: the door to use.
///
/// First the mesh is diagnosed; then the integrals are computed as accurately as was asked for;
/// then the result is looked at.

#include <vector>

#include "tumble/core/rounding.hpp"
#include "tumble/mass/mirtich/mirtich.hpp"
#include "tumble/mass/require_density.hpp"
#include "tumble/mass/require_volume.hpp"
#include "tumble/mass/tetrahedra.hpp"
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
inline MeshIntegrals integrals_over(const PolygonMesh& mesh, Accuracy accuracy,
                                    const simd::LoopOptions& loop) {
  const Vec3 p = reference_point(mesh);
  if (accuracy == Accuracy::textbook)
    return {mirtich::volume_integrals(mesh, p), p, mirtich_errors(mesh, p)};
  const bool fast = accuracy == Accuracy::fast;
  const TetrahedronSums sums = fast ? sum_in_doubles(mesh, p, loop) : sum_in_pairs(mesh, p, loop);
  const double triangles = static_cast<double>(mesh.corners.size());  // no more
  return {with_factors(sums.raw), p,
          fast ? errors_in_doubles(sums.rounding) : errors_in_pairs(sums.rounding, triangles)};
}

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
inline MeshMassProperties mesh_mass_properties(const PolygonMesh& mesh, double density,
                                               const MassOptions& options = {}) {
  require_density(density);
  const std::vector<MeshDefect> findings = diagnose(mesh, options.loop, options.search);
  require_body(findings, options.policy, options.tolerance);
  const BoundedMassProperties body =
      unchecked_mass_properties(mesh, density, options.accuracy, options.loop);
  return {options.policy == Policy::refuse ? require_volume(body) : body, findings};
}

/// @}

}  // namespace tumble
