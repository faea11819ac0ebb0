#pragma once

#include "tumble/mesh/stray_faces.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/edge_balance.hpp"

namespace tumble::detail {

TUMBLE_BODY EdgeSurplus edge_surplus(const PolygonMesh& mesh) {
  EdgeSurplus surplus;
  for_each_uneven_edge(edge_uses(mesh), [&](std::span<const EdgeUse> edge) {
    int& forward = surplus[{edge[0].low, edge[0].high}];
    for (const EdgeUse& use : edge) forward += use.forward ? 1 : -1;
    surplus[{edge[0].high, edge[0].low}] = -forward;
  });
  return surplus;
}

TUMBLE_BODY std::optional<PolygonMesh> without_stray_faces(const PolygonMesh& mesh) {
  EdgeSurplus surplus = edge_surplus(mesh);
  PolygonMesh result = mesh;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    const auto is_over = [&](int a, int b) {
      const auto place = surplus.find({a, b});
      return place != surplus.end() && place->second > 0;
    };
    if (face.size() < 3 || !all_edges(face, is_over) || !has_no_area(mesh, face)) continue;
    all_edges(face, [&](int a, int b) {
      --surplus[{a, b}];
      ++surplus[{b, a}];
      return true;
    });
    const auto begin = result.corners.begin() + mesh.first_corner[static_cast<std::size_t>(f)];
    std::fill_n(begin, face.size(), face[0]);
  }
  if (!is_closed(result)) return {};
  return result;
}

}  // namespace tumble::detail
