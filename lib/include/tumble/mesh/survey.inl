#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/survey.hpp"

namespace tumble::detail {

TUMBLE_BODY Survey survey(const PolygonMesh& mesh, const LatticeFilters& filters,
                          const simd::LoopOptions& options) {
  const Vec3 origin = mesh.corners.empty() ? Vec3(0, 0, 0) : mesh.vertex(mesh.corners[0]);
  const auto add = [&](const TriangleBlock& block, Survey& sum) {
    dispatch(options.instructions, BlockSurvey{block, origin, filters, sum});
  };
  return sum_over_blocks<Survey>(mesh, options, add);
}

}  // namespace tumble::detail
