#pragma once
/// @file
/// All pairs of triangles of a mesh that pass through each other, and places where some touch: the
/// thorough search for crossings.
///
/// Triangles are sorted into the cells of a grid in space; those that share a cell, and whose boxes
/// meet, are looked at exactly. Source: e.g. Ericson, "Real-Time Collision Detection" (2005), §7.1
/// (uniform grids), §7.7.1 (a pair belongs to one cell).

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "tumble/mesh/space_grid.hpp"
#include "tumble/mesh/triangles_meet.hpp"

namespace tumble::detail {

/// Where two triangles meet.
struct TriangleMeeting {
  std::array<int, 2> faces;
  TriangleCrossing crossing;  ///< about where, and how deep; 0 if they only touch
};

/// Those triangles of a mesh for which keep(BoxedTriangle) holds, without those of no area.
template <class Keep>
std::vector<BoxedTriangle> boxed_triangles(const PolygonMesh& mesh, const Keep& keep) {
  std::vector<BoxedTriangle> list;
  for_each_triangle(mesh, [&](int f, const std::array<int, 3>& t) {
    BoxedTriangle boxed{f, t, {}};
    for (const int v : t) boxed.box.extend(mesh.vertex(v));
    if (keep(boxed) && !collinear(mesh.vertex(t[0]), mesh.vertex(t[1]), mesh.vertex(t[2])))
      list.push_back(boxed);
  });
  return list;
}

inline std::vector<BoxedTriangle> boxed_triangles(const PolygonMesh& mesh) {
  return boxed_triangles(mesh, [](const BoxedTriangle&) { return true; });
}

/// How many corners two triangles have in common, by number or by place.
int common_corners(const PolygonMesh& mesh, const std::array<int, 3>& s,
                   const std::array<int, 3>& t);

/// The corners of a triangle of a mesh.
inline Triangle corners_of(const PolygonMesh& mesh, const BoxedTriangle& t) {
  return {mesh.vertex(t.vertices[0]), mesh.vertex(t.vertices[1]), mesh.vertex(t.vertices[2])};
}

/// How two triangles of a mesh lie to each other. Those with a corner in common touch there, which
/// says nothing: they cross only if an edge goes through.
Meeting meeting_of(const PolygonMesh& mesh, const BoxedTriangle& s, const BoxedTriangle& t);

/// Where triangles meet that have no edge in common.
struct TriangleMeetings {
  std::vector<TriangleMeeting> through, touching;

  static constexpr std::size_t most = 100'000;  ///< of each kind: these are places to look at

  void add(const PolygonMesh& mesh, const BoxedTriangle& s, const BoxedTriangle& t) {
    const Meeting meeting = meeting_of(mesh, s, t);
    if (meeting == Meeting::apart) return;
    const bool cross = meeting == Meeting::through;
    std::vector<TriangleMeeting>& list = cross ? through : touching;
    if (list.size() >= most) return;
    const TriangleCrossing crossing =
        cross ? measure_crossing(corners_of(mesh, s), corners_of(mesh, t))
              : TriangleCrossing{s.box.intersection(t.box).center(), 0};
    list.push_back({{s.face, t.face}, crossing});
  }

  void append(const TriangleMeetings& more) {
    through.insert(through.end(), more.through.begin(), more.through.end());
    touching.insert(touching.end(), more.touching.begin(), more.touching.end());
  }

  /// Takes those for touching that are no deeper than rounding may have made them.
  /// @param blur how far it may have moved a coordinate of a vertex [m]
  void forgive(double blur) {
    const auto shallow = std::partition(
        through.begin(), through.end(),
        [=](const TriangleMeeting& meeting) { return meeting.crossing.depth > 4 * blur; });
    touching.insert(touching.end(), shallow, through.end());
    through.erase(shallow, through.end());
  }
};

/// Finds them among some triangles of a mesh.
/// @param most_pairs that a triangle may have on average with those in its cells: where there are
///                   more, as in a fan of thousands of triangles, nothing is looked for
TriangleMeetings find_meetings(const PolygonMesh& mesh, const std::vector<BoxedTriangle>& triangles,
                               double most_pairs = std::numeric_limits<double>::infinity());

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/crossing_pairs.inl"
#endif
