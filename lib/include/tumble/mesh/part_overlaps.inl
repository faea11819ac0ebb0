#pragma once

#include "tumble/mesh/part_overlaps.hpp"

#include <algorithm>
#include <array>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<BoxedTriangle> boxed_parts(const PolygonMesh& mesh,
                                                   const Components& surface) {
  std::vector<BoxedTriangle> list(surface.parts.size());
  for (std::size_t i = 0; i < list.size(); ++i) list[i].face = static_cast<int>(i);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (surface.of_vertex[v] >= 0)
      list[static_cast<std::size_t>(surface.of_vertex[v])].box.extend(mesh.vertices[v]);
  return list;
}

TUMBLE_BODY std::vector<std::vector<Eigen::AlignedBox3d>> overlaps_of_parts(
    const PolygonMesh& mesh, const Components& surface, std::size_t most) {
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

TUMBLE_BODY std::vector<char> hardly_seen_parts(const PolygonMesh& mesh, const Components& surface,
                                                const Eigen::AlignedBox3d& whole, double share) {
  std::vector<char> result;
  for (const BoxedTriangle& part : boxed_parts(mesh, surface)) {
    const Vec3 sides = part.box.sizes().cwiseQuotient(whole.sizes());
    const Vec3 seen(sides.y() * sides.z(), sides.z() * sides.x(), sides.x() * sides.y());
    result.push_back(seen.maxCoeff() < share);
  }
  return result;
}

TUMBLE_BODY std::vector<BoxedTriangle> triangles_near_other_parts(const PolygonMesh& mesh,
                                                                  const Components& surface,
                                                                  std::size_t most,
                                                                  std::size_t few) {
  const auto overlaps = overlaps_of_parts(mesh, surface, few);
  std::size_t near = 0;
  std::vector<BoxedTriangle> list = boxed_triangles(mesh, [&](const BoxedTriangle& t) {
    const int part = surface.of(t.vertices[0]);
    if (part < 0 || near > most) return false;
    const auto& others = overlaps[static_cast<std::size_t>(part)];
    const bool meets =
        std::any_of(others.begin(), others.end(),
                    [&](const Eigen::AlignedBox3d& other) { return t.box.intersects(other); });
    near += meets;
    return meets;
  });
  return near > most ? std::vector<BoxedTriangle>() : list;
}

TUMBLE_BODY std::vector<std::vector<BoxedTriangle>> triangles_of_parts(
    const PolygonMesh& mesh, const Components& surface, const std::vector<char>& wanted) {
  std::vector<std::vector<BoxedTriangle>> lists(wanted.size());
  const auto part_of = [&](const BoxedTriangle& t) {
    return static_cast<std::size_t>(surface.of(t.vertices[0]));
  };
  const auto is_wanted = [&](const BoxedTriangle& t) {
    return surface.of(t.vertices[0]) >= 0 && wanted[part_of(t)];
  };
  for (const BoxedTriangle& t : boxed_triangles(mesh, is_wanted)) lists[part_of(t)].push_back(t);
  return lists;
}

TUMBLE_BODY TriangleMeetings meetings_of_parts(const PolygonMesh& mesh, const Components& surface,
                                               const std::vector<char>& hidden, std::size_t most,
                                               std::size_t few) {
  constexpr double affordable = 1e8;  // pairs: 2 to 3 s
  const auto meetings_among = [&](const std::vector<BoxedTriangle>& triangles) {
    const auto number = static_cast<double>(std::max<std::size_t>(1, triangles.size()));
    return find_meetings(mesh, triangles, std::max(static_cast<double>(few), affordable / number));
  };
  TriangleMeetings found = meetings_among(triangles_near_other_parts(mesh, surface, most, few));
  for (const auto& triangles : triangles_of_parts(mesh, surface, hidden))
    found.append(meetings_among(triangles));
  return found;
}

}  // namespace tumble::detail
