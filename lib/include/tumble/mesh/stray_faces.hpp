#pragma once
/// @file
/// Faces without an area that lie loose on a surface: without them it is closed.
///
/// A face without an area has a use where an edge of one neighbour is two edges of others: it is
/// between them, and all edges are used equally often in both directions. Programs that merge
/// vertices leave others behind that no neighbour needs. They hide no hole, and add nothing.

#include <map>
#include <optional>
#include <span>
#include <utility>

#include "tumble/mesh/check_edges.hpp"

namespace tumble::detail {

/// How much more often an edge is used from its first vertex to its second one than back.
using EdgeSurplus = std::map<std::pair<int, int>, int>;

EdgeSurplus edge_surplus(const PolygonMesh& mesh);

/// Calls `visit(from, to)` for the edges of a face until it gives false.
/// @return whether it never did
template <class Visit>
bool all_edges(std::span<const int> face, const Visit& visit) {
  for (std::size_t k = 0; k < face.size(); ++k) {
    const int a = face[k], b = face[k + 1 < face.size() ? k + 1 : 0];
    if (a != b && !visit(a, b)) return false;
  }
  return true;
}

/// The mesh with the stray faces drawn together to a point, so that the others keep their numbers.
/// @param mesh not closed; indices in range, positions finite
/// @return nothing if it is not closed without them either
std::optional<PolygonMesh> without_stray_faces(const PolygonMesh& mesh);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/stray_faces.inl"
#endif
