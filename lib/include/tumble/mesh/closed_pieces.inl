#pragma once

#include "tumble/mesh/closed_pieces.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/check_edges.hpp"

namespace tumble::detail {

/// Calls `visit(uses of one edge)` for every edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, const Visit& visit) {
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    while (j < uses.size() && uses[i].same_edge(uses[j])) ++j;
    visit(std::span<const EdgeUse>(uses).subspan(i, j - i));
  }
}

/// The pieces that are not closed at an edge.
inline std::vector<int> open_at(std::span<const EdgeUse> edge, DisjointSets& pieces) {
  std::map<int, int> surplus;
  for (const EdgeUse& use : edge) surplus[pieces.root(use.face)] += use.forward ? 1 : -1;
  std::vector<int> open;
  for (const auto& [piece, count] : surplus)
    if (count != 0) open.push_back(piece);
  return open;
}

TUMBLE_BODY std::vector<int> closed_pieces(const PolygonMesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  DisjointSets pieces(static_cast<std::size_t>(mesh.face_count()));
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) pieces.join(edge[0].face, edge[1].face);
  });
  std::vector<std::pair<int, int>> together;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) return;
    const std::vector<int> open = open_at(edge, pieces);
    for (const int piece : open) together.emplace_back(open.front(), piece);
  });
  for (const auto& [a, b] : together) pieces.join(a, b);
  return pieces.roots();
}

TUMBLE_BODY PolygonMesh apart_at_pinches(const PolygonMesh& mesh) {
  const std::vector<int> pieces = closed_pieces(mesh);
  PolygonMesh apart = mesh;
  std::vector<int> owner(mesh.vertices.size(), -1);
  std::map<std::pair<int, int>, int> copies;  // of a vertex, in a piece that does not own it
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = static_cast<std::size_t>(f);
    for (int k = mesh.first_corner[face]; k < mesh.first_corner[face + 1]; ++k) {
      int& v = apart.corners[static_cast<std::size_t>(k)];
      int& piece = owner[static_cast<std::size_t>(v)];
      if (piece < 0) piece = pieces[face];
      if (piece == pieces[face]) continue;
      const auto number = static_cast<int>(apart.vertices.size());
      const auto [copy, is_new] = copies.try_emplace({v, pieces[face]}, number);
      if (is_new) apart.vertices.push_back(mesh.vertex(v));
      v = copy->second;
    }
  }
  return apart;
}

TUMBLE_BODY bool meets_itself(const LineHits& hits, double blur) {
  for (std::size_t i = 0; i < hits.line_count(); ++i) {
    const std::span<const LineHit> line = hits.of_line(i);
    for (std::size_t k = 1; k < line.size(); ++k) {
      const LineHit &below = line[k - 1], &above = line[k];
      if (above.part == below.part && above.direction != below.direction &&
          above.z - below.z <= blur + above.error + below.error)
        return true;
    }
  }
  return false;
}

}  // namespace tumble::detail
