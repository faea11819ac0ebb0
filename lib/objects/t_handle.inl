#pragma once

#include "objects/t_handle.hpp"

#include "objects/sweep.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::objects {

TUMBLE_BODY PolygonMesh t_handle(int r) {
  require(r >= 1, "the resolution of a T-handle must be at least 1, not ", r);
  PolygonMesh mesh;
  constexpr double radius = 0.010, half_length = 0.060, bevel = 0.0015, stem_radius = 0.0075;
  const int n = 8 * r;
  const auto circle = [&](double y, double size) {
    std::vector<Vec3> points;
    for (int j = 0; j < n; ++j)
      points.emplace_back(size * std::sin(2 * pi * j / n), y, size * std::cos(2 * pi * j / n));
    return add_loop(mesh, points);
  };
  // The bar, in 16 r pieces, its ends bevelled.
  std::vector<Loop> bar = {circle(-half_length, radius - bevel)};
  for (int k = -8 * r; k <= 8 * r; ++k)
    bar.push_back(circle((half_length - bevel) * k / (8 * r), radius));
  bar.push_back(circle(half_length, radius - bevel));
  const Patch hole{1 + 7 * r, 2 * r, r, 2 * r};
  join_all(mesh, bar, {hole});
  close_start(mesh, bar.front(), r);
  close(mesh, bar.back(), r);
  // The stem, from a quarter of the bar's circumference.
  const std::vector<Station> way = {{{0.013, 0, 0}, stem_radius, stem_radius},
                                    {{0.075, 0, 0}, stem_radius, stem_radius}};
  const Loop end = sweep(mesh, rim(bar, hole), 2 * r, 2 * r, way, -Vec3::UnitZ(), 1, 8 * r);
  std::vector<Vec3> points;
  for (const int v : end) {
    const Vec3& p = mesh.vertex(v);
    points.emplace_back(p.x() + bevel, p.y() * (1 - bevel / stem_radius),
                        p.z() * (1 - bevel / stem_radius));
  }
  const Loop tip = add_loop(mesh, points);
  join(mesh, end, tip);
  close(mesh, tip, r);
  return without_unused_vertices(mesh);
}

}  // namespace tumble::objects
