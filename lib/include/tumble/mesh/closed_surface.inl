#pragma once

#include "tumble/mesh/closed_surface.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/edge_balance.hpp"

namespace tumble::detail {

TUMBLE_BODY void require_closed(const PolygonMesh& mesh) {
  for (const auto& find : {find_bad_indices, find_not_finite})
    for (const MeshDefect& finding : find(mesh)) require(false, finding.message);
  require(mesh.face_count() > 0, "the mesh has no faces");
  require(is_closed(mesh), "the mesh is not closed: diagnose() says where");
}

}  // namespace tumble::detail
