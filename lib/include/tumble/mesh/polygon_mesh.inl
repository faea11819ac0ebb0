#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

TUMBLE_BODY Eigen::AlignedBox3d bounds(const PolygonMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& v : mesh.vertices) box.extend(v);
  return box;
}

}  // namespace tumble
