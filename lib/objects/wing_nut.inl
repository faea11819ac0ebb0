#pragma once

#include "objects/wing_nut.hpp"

#include "objects/sweep.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::objects {

TUMBLE_BODY PolygonMesh wing_nut(int r) {
  require(r >= 1, "the resolution of a wing nut must be at least 1, not ", r);
  PolygonMesh mesh;
  constexpr double bore = 0.00335, foot = 0.0095, top = 0.0075, height = 0.0115;
  const int n = 16 * r;
  std::vector<Loop> tube;
  const auto add_ring = [&](double size, double z) {
    std::vector<Vec3> points;  // the wings' patches, r cells wide, are centred on x and −x
    for (int j = 0; j < n; ++j) {
      const double angle = 2 * pi * (j - 0.5 * r) / n;
      points.emplace_back(size * std::cos(angle), size * std::sin(angle), z);
    }
    tube.push_back(add_loop(mesh, points));
  };
  const auto part = [](double a, double b, int k, int pieces) { return a + (b - a) * k / pieces; };
  // Out along the foot, up the outside, in along the top, and down the bore.
  for (int k = 0; k < 2 * r; ++k) add_ring(part(bore, foot, k, 2 * r), 0);
  for (int k = 0; k < 4 * r; ++k) add_ring(part(foot, top, k, 4 * r), part(0, height, k, 4 * r));
  for (int k = 0; k < 2 * r; ++k) add_ring(part(top, bore, k, 2 * r), height);
  for (int k = 0; k < 4 * r; ++k) add_ring(bore, part(height, 0, k, 4 * r));
  tube.push_back(tube.front());
  const Patch right{3 * r, 2 * r, 0, r}, left{3 * r, 2 * r, 8 * r, r};
  join_all(mesh, tube, {right, left});
  for (const double side : {1.0, -1.0}) {
    const std::vector<Station> way = {{{side * 0.0102, 0, 0.0064}, 0.0017, 0.0032},
                                      {{side * 0.0135, 0, 0.0088}, 0.0014, 0.0042},
                                      {{side * 0.0175, 0, 0.0127}, 0.0012, 0.0051},
                                      {{side * 0.0205, 0, 0.0162}, 0.0011, 0.0044},
                                      {{side * 0.0220, 0, 0.0181}, 0.0008, 0.0028}};
    const Loop end = sweep(mesh, rim(tube, side > 0 ? right : left), r, 2 * r, way,
                           side * Vec3::UnitY(), 0.6, r);
    close(mesh, end, r);
  }
  return without_unused_vertices(mesh);
}

}  // namespace tumble::objects
