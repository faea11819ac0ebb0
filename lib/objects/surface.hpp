#pragma once
/// @file
/// How the objects are built: loops of vertices, joined one to the next.
///
/// A loop goes counter-clockwise round the direction in which the surface is being built; joining
/// it to the next one makes a band that looks outwards. A patch is a rectangle left out of a tube:
/// its rim is a loop, from which another tube starts (or where one ends).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::objects {

using Loop = std::vector<int>;
inline constexpr double pi = std::numbers::pi;

/// The i-th vertex of a loop, which has no end.
inline int at(const Loop& loop, int i) { return loop[static_cast<std::size_t>(i) % loop.size()]; }
inline int size(const Loop& loop) { return static_cast<int>(loop.size()); }

inline Loop add_loop(PolygonMesh& mesh, const std::vector<Vec3>& points) {
  Loop loop;
  for (const Vec3& p : points) {
    loop.push_back(static_cast<int>(mesh.vertices.size()));
    mesh.vertices.push_back(p);
  }
  return loop;
}

/// Two triangles for the quadrilateral a, b, c, d, cut along its shorter diagonal.
inline void add_quad(PolygonMesh& mesh, int a, int b, int c, int d) {
  const bool along_ac =
      (mesh.vertex(a) - mesh.vertex(c)).norm() <= (mesh.vertex(b) - mesh.vertex(d)).norm();
  mesh.add_face(along_ac ? std::array{a, b, c} : std::array{b, c, d});
  mesh.add_face(along_ac ? std::array{a, c, d} : std::array{b, d, a});
}

/// The band between two loops of equal size.
inline void join(PolygonMesh& mesh, const Loop& from, const Loop& to) {
  for (int i = 0; i < size(from); ++i)
    add_quad(mesh, at(from, i), at(from, i + 1), at(to, i + 1), at(to, i));
}

/// A rectangle of cells of a tube: which loops, and which corners of them.
struct Patch {
  int loop, loops, corner, corners;

  bool contains(int i, int j, int loop_size) const {
    return i >= loop && i < loop + loops && (j - corner + loop_size) % loop_size < corners;
  }
};

/// The bands between consecutive loops, without the cells of the patches.
inline void join_all(PolygonMesh& mesh, const std::vector<Loop>& tube,
                     const std::vector<Patch>& patches) {
  for (int i = 0; i + 1 < static_cast<int>(tube.size()); ++i) {
    const Loop &from = tube[static_cast<std::size_t>(i)],
               &to = tube[static_cast<std::size_t>(i) + 1];
    for (int j = 0; j < size(from); ++j)
      if (std::none_of(patches.begin(), patches.end(),
                       [&](const Patch& p) { return p.contains(i, j, size(from)); }))
        add_quad(mesh, at(from, j), at(from, j + 1), at(to, j + 1), at(to, j));
  }
}

/// The rim of a patch of n × m cells, in steps from its first corner: (along the
/// loop, across loops).
inline std::vector<std::array<int, 2>> rim_steps(int n, int m) {
  std::vector<std::array<int, 2>> steps;
  for (int k = 0; k < n; ++k) steps.push_back({k, 0});
  for (int k = 0; k < m; ++k) steps.push_back({n, k});
  for (int k = n; k > 0; --k) steps.push_back({k, m});
  for (int k = m; k > 0; --k) steps.push_back({0, k});
  return steps;
}

/// The rim of a patch, counter-clockwise seen from outside: a tube can start from it.
inline Loop rim(const std::vector<Loop>& tube, const Patch& p) {
  Loop loop;
  for (const auto& [j, i] : rim_steps(p.corners, p.loops))
    loop.push_back(at(tube[static_cast<std::size_t>(p.loop + i)], p.corner + j));
  return loop;
}

/// The rim of a patch, upside down: a tube that started from an equal patch and bent by
/// 180° ends there.
inline Loop rim_of_end(const std::vector<Loop>& tube, const Patch& p) {
  Loop loop;
  for (const auto& [j, i] : rim_steps(p.corners, p.loops))
    loop.push_back(at(tube[static_cast<std::size_t>(p.loop + p.loops - i)], p.corner + j));
  return loop;
}

/// Closes a tube with a disc: smaller loops in the plane of the last one, then a fan.
inline void close(PolygonMesh& mesh, const Loop& loop, int rings) {
  Vec3 centre = Vec3::Zero();
  for (const int v : loop) centre += mesh.vertex(v) / size(loop);
  Loop outer = loop;
  for (int k = rings - 1; k > 0; --k) {
    std::vector<Vec3> points;
    for (const int v : loop) points.push_back(centre + (mesh.vertex(v) - centre) * k / rings);
    const Loop inner = add_loop(mesh, points);
    join(mesh, outer, inner);
    outer = inner;
  }
  const int middle = add_loop(mesh, {centre})[0];
  for (int i = 0; i < size(outer); ++i) mesh.add_face({at(outer, i), at(outer, i + 1), middle});
}

/// Closes the beginning of a tube.
inline void close_start(PolygonMesh& mesh, const Loop& loop, int rings) {
  close(mesh, Loop(loop.rbegin(), loop.rend()), rings);
}

/// The mesh without vertices that no face uses (those inside a patch).
inline PolygonMesh without_unused_vertices(const PolygonMesh& mesh) {
  PolygonMesh result = mesh;
  result.vertices.clear();
  std::vector<int> new_index(mesh.vertices.size(), -1);
  for (int& v : result.corners) {
    int& index = new_index[static_cast<std::size_t>(v)];
    if (index < 0) {
      index = static_cast<int>(result.vertices.size());
      result.vertices.push_back(mesh.vertex(v));
    }
    v = index;
  }
  return result;
}

}  // namespace tumble::objects
