#pragma once
/// @file
/// The least that a mesh must be to have an inside: what sampling asks before it starts.

#include "tumble/core/require.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/edge_balance.hpp"

namespace tumble::detail {

/// Lets a mesh pass that is closed, whatever its parts do: a tenth of the work of require_body().
/// @throws std::invalid_argument for a mesh with an index out of range, a position that is not
///         finite, no faces, or an open edge
inline void require_closed(const PolygonMesh& mesh) {
  for (const auto& find : {find_bad_indices, find_not_finite})
    for (const MeshDefect& finding : find(mesh)) require(false, finding.message);
  require(mesh.face_count() > 0, "the mesh has no faces");
  require(is_closed(mesh), "the mesh is not closed: diagnose() says where");
}

}  // namespace tumble::detail
