#pragma once

#include "tumble/mesh/weld_if_open.hpp"

#include <algorithm>
#include <vector>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/edge_balance.hpp"
#include "tumble/mesh/stray_faces.hpp"
#include "tumble/mesh/weld.hpp"

namespace tumble::detail {

TUMBLE_BODY bool is_closed_but_for_strays(const PolygonMesh& mesh) {
  if (is_closed(mesh)) return true;
  bool flat = false;
  for (int f = 0; f < mesh.face_count() && !flat; ++f) flat = has_no_area(mesh, mesh.face(f));
  return flat && without_stray_faces(mesh);
}

TUMBLE_BODY int weld_if_open(PolygonMesh& mesh) {
  if (is_closed_but_for_strays(mesh)) return 0;
  const std::vector<int> first = first_at_same_position(mesh);
  std::vector<char> replaced(first.size());
  for (int& corner : mesh.corners) {
    const int v = first[static_cast<std::size_t>(corner)];
    if (v != corner) replaced[static_cast<std::size_t>(corner)] = 1;
    corner = v;
  }
  return static_cast<int>(std::count(replaced.begin(), replaced.end(), 1));
}

}  // namespace tumble::detail
