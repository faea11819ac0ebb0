#pragma once
/// @file
/// Makes neighbours of faces that have vertices of their own at the same positions, where the
/// surface would not be closed else. The vertices keep their numbers, which are those of the file.

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

/// Whether the surface is closed, or would be without faces that have no area.
/// @param mesh indices in range, positions finite
bool is_closed_but_for_strays(const PolygonMesh& mesh);

/// Lets faces take the first of the vertices at exactly equal positions, if the surface is open.
/// @param mesh indices in range, positions finite
/// @return how many vertices no face has any more
int weld_if_open(PolygonMesh& mesh);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/weld_if_open.inl"
#endif
