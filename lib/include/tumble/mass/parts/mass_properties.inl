#pragma once

#include "tumble/mass/parts/mass_properties.hpp"

#include <utility>

#include "tumble/core/compiled.hpp"
#include "tumble/mass/parts/diagnose.hpp"
#include "tumble/mass/require_volume.hpp"

namespace tumble::parts {

TUMBLE_BODY Assembly unchecked_mass_properties(std::span<const Part> parts, Accuracy accuracy,
                                               const simd::LoopOptions& loop) {
  Assembly result;
  std::vector<detail::MeshIntegrals> integrals;
  Eigen::AlignedBox3d box;
  for (const Part& part : parts) {
    integrals.push_back(detail::integrals_over(part.mesh, accuracy, loop));
    box.extend(integrals.back().reference);
    result.parts.push_back(
        {integrals.back().at(part.density), part.name, part.density, part.mesh.face_count()});
  }
  detail::WeightedIntegrals sum(box.center(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) sum.add(integrals[i], parts[i].density);
  static_cast<BoundedMassProperties&>(result) = sum.body();
  return result;
}

TUMBLE_BODY void require_volumes(const Assembly& body) {
  for (const PartMass& part : body.parts)
    detail::require_at([&] { require_volume(part); }, "the part \"", part.name, "\": ");
  require_volume(body);
}

TUMBLE_BODY Assembly mass_properties(const LabelledMesh& mesh, const Densities& densities,
                                     const MassOptions& options) {
  const std::vector<Part> all = split(mesh, densities);
  std::vector<MeshDefect> findings = diagnose(all, options.loop, options.search);
  require_body(findings, options.policy, options.tolerance);
  Assembly body = unchecked_mass_properties(all, options.accuracy, options.loop);
  if (options.policy == Policy::refuse) require_volumes(body);
  body.findings = std::move(findings);
  return body;
}

}  // namespace tumble::parts
