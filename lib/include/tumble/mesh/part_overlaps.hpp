#pragma once
/// @file
/// The triangles that lie in the box of another part than their own. Of an assembly of many parts
/// these are few: the parts' own crossings can be looked for pair by pair, whatever their number.

#include <algorithm>
#include <array>
#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/orientation.hpp"
#include "tumble/mesh/space_grid.hpp"

namespace tumble::detail {

/// The box around each part; `face` is the number of the part.
inline std::vector<BoxedTriangle> boxed_parts(const PolygonMesh& mesh, const Components& surface) {
  std::vector<BoxedTriangle> list(surface.parts.size());
  for (std::size_t i = 0; i < list.size(); ++i) list[i].face = static_cast<int>(i);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (surface.of_vertex[v] >= 0)
      list[static_cast<std::size_t>(surface.of_vertex[v])].box.extend(mesh.vertices[v]);
  return list;
}

/// For each part where its box meets those of others; empty if there are too many to look at.
/// @param most that a part may have, and that a part may have on average in its cells of a grid
inline std::vector<std::vector<Eigen::AlignedBox3d>> overlaps_of_parts(const PolygonMesh& mesh,
                                                                       const Components& surface,
                                                                       std::size_t most) {
  const std::vector<BoxedTriangle> parts = boxed_parts(mesh, surface);
  std::vector<std::vector<Eigen::AlignedBox3d>> overlaps(parts.size());
  const SpaceGrid grid(parts);
  if (grid.pairs() > static_cast<double>(most * parts.size())) return overlaps;
  for_each_close_pair(parts, grid, [&](const BoxedTriangle& s, const BoxedTriangle& t) {
    for (const int part : {s.face, t.face})
      overlaps[static_cast<std::size_t>(part)].push_back(s.box.intersection(t.box));
  });
  for (auto& of_part : overlaps)
    if (of_part.size() > most) of_part.clear();
  return overlaps;
}

/// The triangles that lie in boxes of other parts; none if they are more than `most`.
/// @param few boxes of others that a part is looked at with
inline std::vector<BoxedTriangle> triangles_near_other_parts(const PolygonMesh& mesh,
                                                             const Components& surface,
                                                             std::size_t most, std::size_t few) {
  const auto overlaps = overlaps_of_parts(mesh, surface, few);
  std::vector<BoxedTriangle> list;
  for_each_triangle(mesh, [&](int f, const std::array<int, 3>& t) {
    const int part = surface.of(t[0]);
    if (part < 0 || list.size() > most) return;
    const auto& others = overlaps[static_cast<std::size_t>(part)];
    if (others.empty()) return;
    Eigen::AlignedBox3d box;
    for (const int v : t) box.extend(mesh.vertex(v));
    if (std::none_of(others.begin(), others.end(),
                     [&](const Eigen::AlignedBox3d& other) { return box.intersects(other); }))
      return;
    if (!collinear(mesh.vertex(t[0]), mesh.vertex(t[1]), mesh.vertex(t[2])))
      list.push_back({f, t, box});
  });
  return list.size() > most ? std::vector<BoxedTriangle>() : list;
}

}  // namespace tumble::detail
