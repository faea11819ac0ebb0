#pragma once
/// @file
/// A mug for small drawings: a hundred and fifty flat faces, and no more.

#include "objects/surface.hpp"

namespace tumble::objects {

namespace plain_mug_detail {

inline constexpr int sides = 16;

inline Loop add_ring(PolygonMesh& mesh, double radius, double z) {
  std::vector<Vec3> points;
  for (int j = 0; j < sides; ++j) {
    const double angle = 2 * pi * (j + 0.5) / sides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return add_loop(mesh, points);
}

/// The band between two loops, of quadrilaterals that stay whole.
inline void join_whole(PolygonMesh& mesh, const Loop& from, const Loop& to) {
  for (int i = 0; i < size(from); ++i)
    mesh.add_face({at(from, i), at(from, i + 1), at(to, i + 1), at(to, i)});
}

/// Half an ellipse from the wall to the wall, of square section.
inline void add_handle(PolygonMesh& mesh, double radius, double middle) {
  constexpr int stations = 8;
  constexpr double across = 0.0055, thick = 0.004;
  Loop before;
  for (int k = 0; k <= stations; ++k) {
    const double angle = pi * (0.02 + 0.96 * k / stations);
    const Vec3 out(std::sin(angle), 0, std::cos(angle));
    const Vec3 centre(radius + 0.030 * out.x(), 0, middle + 0.026 * out.z());
    const Vec3 half = thick * out, side = across * Vec3::UnitY();
    const Loop ring = add_loop(mesh, {centre + half + side, centre + half - side,
                                      centre - half - side, centre - half + side});
    if (k > 0) join_whole(mesh, before, ring);
    before = ring;
  }
}

}  // namespace plain_mug_detail

/// Of the size of mug(), its axis along z and its handle towards x. Handle and wall do not share
/// vertices: it is for pictures, and its mass properties mean nothing.
inline PolygonMesh plain_mug() {
  using namespace plain_mug_detail;
  constexpr double radius = 0.041, wall = 0.004, bottom = 0.006, height = 0.095, middle = 0.053;
  PolygonMesh mesh;
  const Loop foot = add_ring(mesh, radius, 0), half_way = add_ring(mesh, radius, height / 2),
             lip = add_ring(mesh, radius, height), inside = add_ring(mesh, radius - wall, height),
             floor = add_ring(mesh, radius - wall, bottom);
  mesh.add_face(Loop(foot.rbegin(), foot.rend()));
  join_whole(mesh, foot, half_way);
  join_whole(mesh, half_way, lip);
  join_whole(mesh, lip, inside);
  join_whole(mesh, inside, floor);
  mesh.add_face(floor);
  add_handle(mesh, radius, middle);
  return mesh;
}

}  // namespace tumble::objects
