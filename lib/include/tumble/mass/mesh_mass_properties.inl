#pragma once

#include "tumble/mass/mesh_mass_properties.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/mass/mirtich/mirtich.hpp"
#include "tumble/mass/require_density.hpp"
#include "tumble/mass/require_volume.hpp"
#include "tumble/mass/tetrahedra.hpp"

namespace tumble::detail {

TUMBLE_BODY MeshIntegrals integrals_over(const PolygonMesh& mesh, Accuracy accuracy,
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

}  // namespace tumble::detail

namespace tumble {

TUMBLE_BODY MeshMassProperties mesh_mass_properties(const PolygonMesh& mesh, double density,
                                                    const MassOptions& options) {
  require_density(density);
  const std::vector<MeshDefect> findings = diagnose(mesh, options.loop, options.search);
  require_body(findings, options.policy, options.tolerance);
  const BoundedMassProperties body =
      unchecked_mass_properties(mesh, density, options.accuracy, options.loop);
  return {options.policy == Policy::refuse ? require_volume(body) : body, findings};
}

}  // namespace tumble
