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
LineBundle hits_of_bundle(const PolygonMesh& mesh, const Components& surface,
                          const Eigen::AlignedBox3d& box, const LineLattices& lattices,
                          const TrianglesNearLines& near, double blur);

/// How deep inside the others each part lies, and whether it crosses itself, as all lines say.
std::vector<PartDepth> measure_parts(const LineBundle& bundle, const Components& surface);

/// The largest coordinate of all that is in a box, without its sign [m].
inline double largest_coordinate(const Eigen::AlignedBox3d& box) {
  return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

/// How far rounding to doubles may have moved a coordinate [m].
inline double double_blur(const Eigen::AlignedBox3d& box) {
  return 8 * unit_roundoff * largest_coordinate(box);
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/line_bundle.inl"
#endif
