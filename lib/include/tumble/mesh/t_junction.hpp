#pragma once
/// @file
/// T-junctions: a corner of one face that lies in the middle of another one's edge. Seen from both
/// sides the surface has no gap there, and all the same each face has an edge of its own.

#include <optional>
#include <span>
#include <string>

#include "tumble/mesh/edge_use.hpp"

namespace tumble::detail {

/// A vertex in the middle of an edge that does not have it.
struct TJunction {
  int vertex;
  EdgeUse edge;
};

/// Whether a vertex lies between the ends of an edge, and next to neither.
bool lies_in_middle(const PolygonMesh& mesh, const EdgeUse& edge, int vertex);

/// The T-junction that an open edge is at: with a vertex in its middle, or an end in the middle of
/// another one.
/// @param open all open edges
std::optional<TJunction> t_junction_at(const PolygonMesh& mesh, const EdgeUse& edge,
                                       std::span<const EdgeUse> open);

/// "; vertex #9 at (…) lies in the middle of the edge from … to …", or nothing.
std::string describe_t_junction(const PolygonMesh& mesh, const EdgeUse& edge,
                                std::span<const EdgeUse> open);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/t_junction.inl"
#endif
