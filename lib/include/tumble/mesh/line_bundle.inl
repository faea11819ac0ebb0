#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/line_bundle.hpp"

namespace tumble::detail {

TUMBLE_BODY LineBundle hits_of_bundle(const PolygonMesh& mesh, const Components& surface,
                                      const Eigen::AlignedBox3d& box, const LineLattices& lattices,
                                      const TrianglesNearLines& near, double blur) {
  LineBundle bundle;
  for (std::size_t i = 0; i < 3; ++i) {
    const LinesOnMesh lines{mesh, surface, View{static_cast<int>(i)}, blur};
    bundle.along[i] = hits_of_lattice(lines, lattices.along[i], near.along[i]);
  }
  if (surface.parts.size() == 1) return bundle;
  const LineList lines(box, lines_through_parts(mesh, surface));
  bundle.through_parts = hits_of_lines({mesh, surface, View{2}, blur}, lines);
  return bundle;
}

TUMBLE_BODY std::vector<PartDepth> measure_parts(const LineBundle& bundle,
                                                 const Components& surface) {
  std::vector<PartDepth> result(surface.parts.size());
  if (result.size() == 1) result[0].least_around = result[0].most_around = 0;
  bundle.for_each([&](const LineHits& hits) { measure_parts(hits, surface, result); });
  return result;
}

}  // namespace tumble::detail
