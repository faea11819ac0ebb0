#pragma once
/// @file
/// Some thousand lines along each axis, and what they say about the depth of a surface.

#include <array>
#include <vector>

#include "tumble/mesh/depth.hpp"

namespace tumble::detail {

/// The hits of the lines along each axis, and, when the surface has several parts, of one line
/// along z through each.
struct LineBundle {
  std::array<LineHits, 3> along;
  LineHits through_parts{{}, {0}};

  /// Calls `visit(hits)` for each.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const LineHits& hits : along) visit(hits);
    visit(through_parts);
  }
};

/// Where the lines meet the mesh.
/// @param box  around all vertices
/// @param near triangles that may meet a line
/// @param blur how far rounding may have moved a coordinate of a vertex [m]
inline LineBundle hits_of_bundle(const PolygonMesh& mesh, const Components& surface,
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

/// How deep inside the others each part lies, and whether it crosses itself, as all lines say.
inline std::vector<PartDepth> measure_parts(const LineBundle& bundle, const Components& surface) {
  std::vector<PartDepth> result(surface.parts.size());
  if (result.size() == 1) result[0].least_around = result[0].most_around = 0;
  bundle.for_each([&](const LineHits& hits) { measure_parts(hits, surface, result); });
  return result;
}

/// How far rounding to doubles may have moved a coordinate [m].
inline double double_blur(const Eigen::AlignedBox3d& box) {
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return 8 * unit_roundoff * largest;
}

}  // namespace tumble::detail
