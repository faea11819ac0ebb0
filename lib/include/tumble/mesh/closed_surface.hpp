#pragma once
/// @file
/// The least that a mesh must be to have an inside: what sampling asks before it starts.

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

/// Lets a mesh pass that is closed, whatever its parts do: a tenth of the work of require_body().
/// @throws std::invalid_argument for a mesh with an index out of range, a position that is not
///         finite, no faces, or an open edge
void require_closed(const PolygonMesh& mesh);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/closed_surface.inl"
#endif
