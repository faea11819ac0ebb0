#pragma once
/// @file
/// A point near the middle of a mesh, for integrals to be taken about.

#include <algorithm>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

/// The middle of the box around a few hundred corners, taken evenly from all faces [m]. Vertices
/// that no face uses do not count. Any point near the body will do: the farther away it is,
/// measured in sizes of the body, the more digits cancel.
/// @param mesh indices in range
inline Vec3 reference_point(const PolygonMesh& mesh) {
  constexpr std::size_t samples = 256;
  Eigen::AlignedBox3d box;
  const std::size_t step = std::max<std::size_t>(1, mesh.corners.size() / samples);
  for (std::size_t i = 0; i < mesh.corners.size(); i += step)
    box.extend(mesh.vertex(mesh.corners[i]));
  return box.isEmpty() ? Vec3(0, 0, 0) : Vec3(box.center());
}

}  // namespace tumble::detail
