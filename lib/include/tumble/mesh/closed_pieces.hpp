#pragma once
/// @file
/// The closed pieces of a surface that hang together only where they touch: at a vertex, or at an
/// edge of more than two faces. As parts of one mesh they have these vertices in common.

#include <span>
#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

/// For each face the number of its piece. Neighbours across an edge of two faces are in one piece.
/// If that makes no closed surface, so are the others that meet at an edge.
/// @param mesh closed
std::vector<int> closed_pieces(const PolygonMesh& mesh);

/// The mesh with vertices of its own for each piece: each is a part then. Faces stay as they are.
/// @param mesh closed
PolygonMesh apart_at_pinches(const PolygonMesh& mesh);

/// How a face goes past one of its vertices.
struct Passage {
  int from, to;  ///< the vertices before it and after it
};

/// Whether the faces around a vertex are one fan: you get from each to all others across edges that
/// have two faces.
/// @param around the vertex of a closed mesh; we sort them if they are many
bool is_one_fan(std::span<Passage> around);

/// Whether a surface touches itself at a vertex or an edge: only there can pieces hang together
/// that are closed without each other. Costs some 10 ns a corner.
/// @param mesh closed
bool is_pinched(const PolygonMesh& mesh);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/closed_pieces.inl"
#endif
