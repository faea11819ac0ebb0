#pragma once
/// @file
/// Makes one vertex of several at the same position: many files (STL, scans, exports with texture
/// seams) give each face its own corners, so that no two faces share an edge.

#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

namespace detail {

/// For each vertex the first one at exactly the same position: itself, if there is none before it.
/// @param mesh positions finite
std::vector<int> first_at_same_position(const PolygonMesh& mesh);

}  // namespace detail

/// @addtogroup mesh
/// @{

/// The mesh with vertices at exactly equal positions merged (0 and −0 are equal). Vertices keep
/// their order, the first of equal ones stays; faces keep their order and their corners.
/// @param mesh indices in range, positions finite
PolygonMesh weld(const PolygonMesh& mesh);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/weld.inl"
#endif
