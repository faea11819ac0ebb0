#pragma once
/// @file
/// The closed pieces of a surface that hang together only where they touch: at a vertex, or at an
/// edge of more than two faces. As parts of one mesh they have these vertices in common.

#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/edge_use.hpp"
#include "tumble/mesh/line_bundle.hpp"

namespace tumble::detail {

/// For each face the number of its piece. Neighbours across an edge of two faces are in one piece.
/// If that makes no closed surface, so are the others that meet at an edge.
/// @param mesh closed
std::vector<int> closed_pieces(const PolygonMesh& mesh);

/// The mesh with vertices of its own for each piece: each is a part then. Faces stay as they are.
/// @param mesh closed
PolygonMesh apart_at_pinches(const PolygonMesh& mesh);

/// Whether a line leaves a part where it enters it, up to `blur` [m]: the part may be pieces that
/// touch.
bool meets_itself(const LineHits& hits, double blur);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/closed_pieces.inl"
#endif
