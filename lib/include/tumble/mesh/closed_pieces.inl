#pragma once

#include "tumble/mesh/closed_pieces.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/check_edges.hpp"

namespace tumble::detail {

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

/// Calls `visit(vertex, passage)` for each corner. Where a face goes back to the vertex it came
/// from, it adds nothing to the fan: such faces have no area.
template <class Visit>
void for_each_passage(const PolygonMesh& mesh, const Visit& visit) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    if (face.empty()) continue;
    int from = face.back();
    for (std::size_t k = face.size(); from == face[0] && k > 0;) from = face[--k];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int v = face[k], to = face[k + 1 < face.size() ? k + 1 : 0];
      if (to == v) continue;  // a corner that is there twice is one
      if (from != to) visit(v, Passage{from, to});
      from = v;
    }
  }
}

TUMBLE_BODY bool is_one_fan(std::span<Passage> around) {
  constexpr std::size_t few = 16;
  const auto before = [](const Passage& passage, int v) { return passage.from < v; };
  const bool sorted = around.size() > few;
  if (sorted)
    std::sort(around.begin(), around.end(),
              [](const Passage& a, const Passage& b) { return a.from < b.from; });
  const auto next = [&](const Passage& passage) {
    if (sorted) return std::lower_bound(around.begin(), around.end(), passage.to, before);
    return std::find_if(around.begin(), around.end(),
                        [&](const Passage& other) { return other.from == passage.to; });
  };
  // Of two that come from the same vertex we always take the first. So if an edge has four faces,
  // one passage is never met, and we are back too early or go round elsewhere.
  auto place = around.begin();
  for (std::size_t steps = 1; steps <= around.size(); ++steps) {
    place = next(*place);
    if (place == around.end()) return false;
    if (place == around.begin()) return steps == around.size();
  }
  return around.empty();
}

TUMBLE_BODY bool is_pinched(const PolygonMesh& mesh) {
  // Sorted by their vertices: those around v end where those around v + 1 begin.
  std::vector<std::size_t> begin(mesh.vertices.size() + 2, 0);
  const auto at = [](int v) { return static_cast<std::size_t>(v); };
  for_each_passage(mesh, [&](int v, const Passage&) { ++begin[at(v) + 2]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Passage> passages(begin.back());
  for_each_passage(mesh,
                   [&](int v, const Passage& passage) { passages[begin[at(v) + 1]++] = passage; });
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (!is_one_fan(std::span(passages).subspan(begin[v], begin[v + 1] - begin[v]))) return true;
  return false;
}

}  // namespace tumble::detail
