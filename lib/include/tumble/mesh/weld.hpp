#pragma once
/// @file
/// Makes one vertex of several at the same position: many files (STL, scans, exports with texture
/// seams) give each face its own corners, so that no two faces share an edge.

#include <algorithm>
#include <numeric>
#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

/// The mesh with vertices at exactly equal positions merged (0 and −0 are equal). Vertices keep
/// their order, the first of equal ones stays; faces keep their order and their corners.
/// @param mesh indices in range, positions finite
inline PolygonMesh weld(const PolygonMesh& mesh) {
  const std::size_t n = mesh.vertices.size();
  std::vector<std::size_t> by_position(n);
  std::iota(by_position.begin(), by_position.end(), std::size_t{0});
  const auto less = [&](std::size_t i, std::size_t j) {
    const Vec3 &a = mesh.vertices[i], &b = mesh.vertices[j];
    for (int k = 0; k < 3; ++k)
      if (a[k] != b[k]) return a[k] < b[k];
    return i < j;
  };
  std::sort(by_position.begin(), by_position.end(), less);
  // The first of each run of equal positions speaks for the run.
  std::vector<std::size_t> speaker(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = by_position[k];
    const bool same = k > 0 && mesh.vertices[by_position[k - 1]] == mesh.vertices[i];
    speaker[i] = same ? speaker[by_position[k - 1]] : i;
  }
  PolygonMesh welded;
  std::vector<int> new_index(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (speaker[i] == i) welded.vertices.push_back(mesh.vertices[i]);
    new_index[i] =
        speaker[i] == i ? static_cast<int>(welded.vertices.size()) - 1 : new_index[speaker[i]];
  }
  welded.first_corner = mesh.first_corner;
  welded.corners.reserve(mesh.corners.size());
  for (const int v : mesh.corners) welded.corners.push_back(new_index[static_cast<std::size_t>(v)]);
  return welded;
}

/// @}

}  // namespace tumble
