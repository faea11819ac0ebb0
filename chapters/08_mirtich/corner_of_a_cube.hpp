#pragma once
/// @file
/// The corner that is cut off a cube: a tetrahedron for paper.

#include "common.hpp"

namespace mirtich_chapter {

/// Three edges of length 1 along the axes; the slanted face comes first.
inline PolygonMesh corner_of_a_cube() {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& face : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}})
    mesh.add_face(face);
  return mesh;
}

}  // namespace mirtich_chapter
