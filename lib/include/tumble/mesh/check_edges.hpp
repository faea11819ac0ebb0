#pragma once
/// @file
/// Names the edges at which a surface is not closed. Slow (it sorts all edges), and so only asked
/// when is_closed() has said that there are some.

#include <span>
#include <string>
#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/edge_use.hpp"
#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

/// All uses of all edges, those of the same edge side by side.
std::vector<EdgeUse> edge_uses(const PolygonMesh& mesh);

/// Calls `visit(uses of one edge)` for every edge that is not used equally often both ways.
template <class Visit>
void for_each_uneven_edge(const std::vector<EdgeUse>& uses, Visit&& visit) {
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    int balance = 0;
    for (const EdgeUse& use : edge) balance += use.forward ? 1 : -1;
    if (balance != 0) visit(edge);
  });
}

/// Finds faces that have exactly the vertices of an earlier face. Only worth asking for a mesh that
/// is not closed: a face and its mirror image add nothing, and are a part that touches itself.
std::vector<MeshDefect> find_duplicate_faces(const PolygonMesh& mesh);

/// "faces #1, #2 and #9".
std::string describe_faces(std::span<const EdgeUse> uses);

/// The two sides of each face, 2 f and 2 f + 1. Those that look the same way across an edge of two
/// faces are joined: if both sides of a face are, the surface around it has one side only.
DisjointSets joined_sides(const PolygonMesh& mesh, const std::vector<EdgeUse>& uses);

/// Two faces that go along an edge in the same direction, and whether turning one is a cure.
std::string describe_turned(const PolygonMesh& mesh, std::span<const EdgeUse> edge,
                            DisjointSets& sides);

/// Finds where the surface is not closed: open edges, neighbours that disagree on what is outside,
/// and edges with an odd company of faces.
/// @param mesh indices in range
std::vector<MeshDefect> find_uneven_edges(const PolygonMesh& mesh);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/check_edges.inl"
#endif
