#pragma once

#include "tumble/mesh/crossing_pairs.hpp"

#include <span>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY int common_corners(const PolygonMesh& mesh, const std::array<int, 3>& s,
                               const std::array<int, 3>& t) {
  int common = 0;
  for (const int v : s)
    for (const int w : t) common += v == w || mesh.vertex(v) == mesh.vertex(w);
  return common;
}

TUMBLE_BODY Meeting meeting_of(const PolygonMesh& mesh, const BoxedTriangle& s,
                               const BoxedTriangle& t) {
  const int common = common_corners(mesh, s.vertices, t.vertices);
  if (common > 1) return Meeting::apart;
  const Triangle a = corners_of(mesh, s), b = corners_of(mesh, t);
  if (common == 0) return triangles_meet(a, b);
  const bool cross = triangles_meet_beside(a, b) == Meeting::through;
  return cross ? Meeting::through : Meeting::apart;
}

TUMBLE_BODY TriangleMeetings find_meetings(const PolygonMesh& mesh,
                                           const std::vector<BoxedTriangle>& triangles,
                                           double most_pairs) {
  TriangleMeetings found;
  if (triangles.empty()) return found;
  const SpaceGrid grid(triangles);
  if (grid.pairs() > most_pairs * static_cast<double>(triangles.size())) return found;
  for_each_close_pair(triangles, grid, [&](const BoxedTriangle& s, const BoxedTriangle& t) {
    found.add(mesh, s, t);
  });
  return found;
}

}  // namespace tumble::detail
