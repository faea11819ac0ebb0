#pragma once
/// @file
/// Faces without an area that lie loose on a surface: without them it is closed.
///
/// A face without an area has a use where an edge of one neighbour is two edges of others: it is
/// between them, and all edges are used equally often in both directions. Programs that merge
/// vertices leave others behind that no neighbour needs. They hide no hole, and add nothing.

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/check_faces.hpp"

namespace tumble::detail {

/// How much more often an edge is used from its first vertex to its second one than back.
using EdgeSurplus = std::map<std::pair<int, int>, int>;

inline EdgeSurplus edge_surplus(const PolygonMesh& mesh) {
  EdgeSurplus surplus;
  for_each_uneven_edge(edge_uses(mesh), [&](std::span<const EdgeUse> edge) {
    int& forward = surplus[{edge[0].low, edge[0].high}];
    for (const EdgeUse& use : edge) forward += use.forward ? 1 : -1;
    surplus[{edge[0].high, edge[0].low}] = -forward;
  });
  return surplus;
}

/// Calls `visit(from, to)` for the edges of a face until it gives false.
/// @return whether it never did
template <class Visit>
bool all_edges(std::span<const int> face, const Visit& visit) {
  for (std::size_t k = 0; k < face.size(); ++k) {
    const int a = face[k], b = face[k + 1 < face.size() ? k + 1 : 0];
    if (a != b && !visit(a, b)) return false;
  }
  return true;
}

/// The mesh with the stray faces drawn together to a point, so that the others keep their numbers.
/// @param mesh not closed; indices in range, positions finite
/// @return nothing if it is not closed without them either
inline std::optional<PolygonMesh> without_stray_faces(const PolygonMesh& mesh) {
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
