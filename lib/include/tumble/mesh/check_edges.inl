#pragma once

#include "tumble/mesh/check_edges.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/edge_balance.hpp"
#include "tumble/mesh/t_junction.hpp"
#include "tumble/mesh/weld.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<EdgeUse> edge_uses(const PolygonMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(mesh.corners.size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[k + 1 < face.size() ? k + 1 : 0];
      if (a != b) uses.push_back({std::min(a, b), std::max(a, b), f, a < b});
    }
  }
  const auto order = [](const EdgeUse& u, const EdgeUse& v) {
    if (u.low != v.low) return u.low < v.low;
    return u.high != v.high ? u.high < v.high : u.face < v.face;
  };
  std::sort(uses.begin(), uses.end(), order);
  return uses;
}

TUMBLE_BODY std::vector<MeshDefect> find_duplicate_faces(const PolygonMesh& mesh) {
  std::vector<std::vector<int>> keys;
  std::vector<int> order;
  for (int f = 0; f < mesh.face_count(); ++f) {
    keys.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    std::sort(keys.back().begin(), keys.back().end());
    order.push_back(f);
  }
  const auto key = [&](int f) -> const std::vector<int>& {
    return keys[static_cast<std::size_t>(f)];
  };
  std::sort(order.begin(), order.end(),
            [&](int f, int g) { return key(f) != key(g) ? key(f) < key(g) : f < g; });
  MeshDefectsOfOneKind duplicates(MeshDefectKind::duplicate_face);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const int f = order[i], original = order[i - 1];
    if (key(f) != key(original) || key(f).size() < 3) continue;
    duplicates.add(f, {-1, -1}, [&] {
      return "face #" + std::to_string(f + 1) + " has the same vertices as face #" +
             std::to_string(original + 1) + ": take one of them away";
    });
  }
  std::vector<MeshDefect> findings;
  duplicates.append_to(findings);
  return findings;
}

TUMBLE_BODY std::string describe_faces(std::span<const EdgeUse> uses) {
  std::string text = uses.size() == 1 ? "face #" : "faces #";
  for (std::size_t i = 0; i < uses.size() && i < 6; ++i)
    text += (i == 0                 ? ""
             : i + 1 == uses.size() ? " and #"
                                    : ", #") +
            std::to_string(uses[i].face + 1);
  return uses.size() > 6 ? text + ", …" : text;
}

TUMBLE_BODY DisjointSets joined_sides(const PolygonMesh& mesh, const std::vector<EdgeUse>& uses) {
  DisjointSets sides(2 * static_cast<std::size_t>(mesh.face_count()));
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const int a = 2 * edge[0].face, b = 2 * edge[1].face;
    const int turned = edge[0].forward == edge[1].forward ? 1 : 0;
    sides.join(a, b + turned);
    sides.join(a + 1, b + 1 - turned);
  });
  return sides;
}

TUMBLE_BODY std::string describe_turned(const PolygonMesh& mesh, std::span<const EdgeUse> edge,
                                        DisjointSets& sides) {
  const int side = 2 * edge.front().face;
  return describe_faces(edge) + " go along " + describe_edge(mesh, edge.front()) +
         " in the same direction: " +
         (sides.root(side) == sides.root(side + 1)
              ? "the surface has one side only, as a Möbius strip has. Turning faces is no cure"
              : "one of them is turned the wrong way round");
}

TUMBLE_BODY std::vector<MeshDefect> find_uneven_edges(const PolygonMesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  std::vector<EdgeUse> all_open;
  for_each_uneven_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) all_open.push_back(edge.front());
  });
  const bool finite = std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                                  [](const Vec3& p) { return p.allFinite(); });
  const std::string cure = !all_open.empty() && finite && is_closed(weld(mesh))
                               ? "; the surface is closed once vertices at equal positions are "
                                 "merged: call weld(), or save the mesh as STL"
                               : "";
  DisjointSets sides = joined_sides(mesh, uses);
  MeshDefectsOfOneKind open(MeshDefectKind::open_edge), uneven(MeshDefectKind::uneven_edge);
  MeshDefectsOfOneKind turned(MeshDefectKind::inconsistent_orientation);
  for_each_uneven_edge(uses, [&](std::span<const EdgeUse> edge) {
    const EdgeUse& first = edge.front();
    if (edge.size() == 1)
      open.add(first.face, {first.low, first.high}, [&] {
        return describe_edge(mesh, first) + " has " + describe_faces(edge) +
               " on one side and nothing on the other (open edges in all: " +
               std::to_string(all_open.size()) + ")" +
               (cure.empty() ? describe_t_junction(mesh, first, all_open) : cure);
      });
    else if (edge.size() == 2)
      turned.add(first.face, {first.low, first.high},
                 [&] { return describe_turned(mesh, edge, sides); });
    else
      uneven.add(first.face, {first.low, first.high}, [&] {
        return describe_edge(mesh, first) + " has " + std::to_string(edge.size()) +
               " faces, unequally many in the two directions: " + describe_faces(edge);
      });
  });
  std::vector<MeshDefect> findings;
  open.append_to(findings);
  turned.append_to(findings);
  uneven.append_to(findings);
  return findings;
}

}  // namespace tumble::detail
