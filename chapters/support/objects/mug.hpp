#pragma once
/// @file
/// A mug: its axis along z, its handle towards x.

#include "support/objects/sweep.hpp"

namespace tumble::objects {

/// A mug 9.6 cm high with walls of 4 mm, about 1,200 r² triangles. @param r resolution, from 1
inline PolygonMesh mug(int r) {
  PolygonMesh mesh;
  constexpr double radius = 0.041, wall = 0.004, bottom = 0.006, height = 0.094, bevel = 0.003;
  const int n = 24 * r;
  std::vector<Loop> tube;
  const auto add_ring = [&](double size, double z) {
    std::vector<Vec3> points;  // the handle's patch, r cells wide, is centred on x
    for (int j = 0; j < n; ++j) {
      const double angle = 2 * pi * (j - 0.5 * r) / n;
      points.emplace_back(size * std::cos(angle), size * std::sin(angle), z);
    }
    tube.push_back(add_loop(mesh, points));
  };
  // Up the outside, over the lip, and down the inside.
  add_ring(radius - bevel, 0);
  for (int k = 0; k <= 9 * r; ++k) add_ring(radius, bevel + (height - bevel) * k / (9 * r));
  add_ring(radius - wall / 2, height + wall / 2);
  for (int k = 9 * r; k >= 0; --k)
    add_ring(radius - wall, bottom + bevel + (height - bottom - bevel) * k / (9 * r));
  add_ring(radius - wall - bevel, bottom);
  const Patch upper{1 + 7 * r, r, 0, r}, lower{1 + 2 * r, r, 0, r};
  join_all(mesh, tube, {upper, lower});
  close_start(mesh, tube.front(), 3 * r);
  close(mesh, tube.back(), 3 * r);
  // The handle: half an ellipse from one patch to the other.
  const double top = (mesh.vertex(tube[static_cast<std::size_t>(upper.loop)][0]).z() +
                      mesh.vertex(tube[static_cast<std::size_t>(upper.loop + r)][0]).z()) /
                     2;
  const double foot = (mesh.vertex(tube[static_cast<std::size_t>(lower.loop)][0]).z() +
                       mesh.vertex(tube[static_cast<std::size_t>(lower.loop + r)][0]).z()) /
                      2;
  std::vector<Station> way;
  for (double angle = 0.09; angle < 0.95; angle += 0.082)
    way.push_back({{radius + 0.030 * std::sin(pi * angle), 0,
                    (top + foot) / 2 + (top - foot) / 2 * std::cos(pi * angle)},
                   0.0055,
                   0.0040});
  const Loop end = sweep(mesh, rim(tube, upper), r, r, way, Vec3::UnitY(), 0.7, r);
  join(mesh, end, rim_of_end(tube, lower));
  return mesh;
}

}  // namespace tumble::objects
