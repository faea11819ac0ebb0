#pragma once

#include "objects/mug.hpp"

#include "objects/sweep.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::objects {

TUMBLE_BODY PolygonMesh mug(int r) {
  require(r >= 1, "the resolution of a mug must be at least 1, not ", r);
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
  // The handle: half an ellipse from the middle of one patch to that of the other.
  const double row = (height - bevel) / (9 * r), middle = bevel + (5 * r + 0.5 * r) * row,
               rise = 2.5 * r * row;
  std::vector<Station> way;
  for (int k = 0; k <= 10; ++k) {
    const double angle = pi * (0.09 + 0.082 * k);
    way.push_back(
        {{radius + 0.030 * std::sin(angle), 0, middle + rise * std::cos(angle)}, 0.0055, 0.0040});
  }
  const Loop end = sweep(mesh, rim(tube, upper), r, r, way, Vec3::UnitY(), 0.7, r);
  join(mesh, end, rim_of_end(tube, lower));
  return without_unused_vertices(mesh);
}

}  // namespace tumble::objects
