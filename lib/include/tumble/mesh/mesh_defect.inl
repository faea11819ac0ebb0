#pragma once

#include "tumble/mesh/mesh_defect.hpp"

#include <sstream>

#include "tumble/core/compiled.hpp"

namespace tumble {

TUMBLE_BODY const char* name_of(MeshDefectKind kind) {
  switch (kind) {
    case MeshDefectKind::no_faces:
      return "no_faces";
    case MeshDefectKind::index_out_of_range:
      return "index_out_of_range";
    case MeshDefectKind::not_finite:
      return "not_finite";
    case MeshDefectKind::degenerate_face:
      return "degenerate_face";
    case MeshDefectKind::nonplanar_face:
      return "nonplanar_face";
    case MeshDefectKind::open_edge:
      return "open_edge";
    case MeshDefectKind::inconsistent_orientation:
      return "inconsistent_orientation";
    case MeshDefectKind::duplicate_face:
      return "duplicate_face";
    case MeshDefectKind::uneven_edge:
      return "uneven_edge";
    case MeshDefectKind::flat:
      return "flat";
    case MeshDefectKind::inverted:
      return "inverted";
    case MeshDefectKind::nested_wrong:
      return "nested_wrong";
    case MeshDefectKind::self_crossing:
      return "self_crossing";
  }
  return "?";
}

}  // namespace tumble

namespace tumble::detail {

TUMBLE_BODY std::string describe_vertex(const PolygonMesh& mesh, int v) {
  std::ostringstream text;
  text.precision(9);
  const Vec3& p = mesh.vertex(v);
  text << "vertex #" << v + 1 << " at (" << p.x() << ", " << p.y() << ", " << p.z() << ")";
  return text.str();
}

}  // namespace tumble::detail
