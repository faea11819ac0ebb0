#pragma once

#include "objects/tennis_racket.hpp"

#include "objects/sweep.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::objects {

/// A string between ±half_length along direction k (0: x, 1: y), at `across` beside the middle.
inline void add_string(PolygonMesh& mesh, int k, double across, double half_length, double z) {
  constexpr double half = 0.00065;
  Vec3 low(-half, -half, z - half), high(half, half, z + half);
  low[k] = -half_length;
  high[k] = half_length;
  low[1 - k] += across, high[1 - k] += across;
  const std::vector<Vec3> foot = {{low.x(), low.y(), low.z()},
                                  {high.x(), low.y(), low.z()},
                                  {high.x(), high.y(), low.z()},
                                  {low.x(), high.y(), low.z()}};
  std::vector<Vec3> top = foot;
  for (Vec3& p : top) p.z() = high.z();
  const Loop a = add_loop(mesh, foot), b = add_loop(mesh, top);
  for (int i = 0; i < 4; ++i) mesh.add_face({at(a, i), at(a, i + 1), at(b, i + 1), at(b, i)});
  mesh.add_face(Loop(a.rbegin(), a.rend()));
  mesh.add_face(b);
}

/// Strings along direction k, `count` of them, `spacing` apart, at height z.
inline void add_strings(PolygonMesh& mesh, int k, int count, double spacing, double z) {
  constexpr double gap = 0.0015;
  const double along = (k == 0 ? head_length : head_width) - frame_half_width - gap;
  const double across = (k == 0 ? head_width : head_length) - frame_half_width - gap;
  for (int i = 0; i < count; ++i) {
    const double place = spacing * (i - 0.5 * (count - 1)),
                 s = (std::abs(place) + 0.00065) / across;
    add_string(mesh, k, place, along * std::sqrt(1 - s * s), z);
  }
}

TUMBLE_BODY PolygonMesh tennis_racket(int r) {
  require(r >= 1, "the resolution of a tennis racket must be at least 1, not ", r);
  PolygonMesh mesh;
  const int loops = 64 * r, corners = 4 * r;
  std::vector<Loop> frame;
  for (int i = 0; i < loops; ++i) {
    const double u = 2 * pi * i / loops;
    const Vec3 centre(head_length * std::cos(u), head_width * std::sin(u), 0);
    const Vec3 outwards = Vec3(head_width * std::cos(u), head_length * std::sin(u), 0).normalized();
    std::vector<Vec3> points;
    for (int j = 0; j < corners; ++j) {
      const double angle = pi / 4 + 2 * pi * j / corners;
      const Eigen::Vector2d p = section_point(std::cos(angle), std::sin(angle), 0.5);
      points.push_back(centre + frame_half_height * p.x() * Vec3::UnitZ() +
                       frame_half_width * p.y() * outwards);
    }
    frame.push_back(add_loop(mesh, points));
  }
  frame.push_back(frame.front());
  const Patch throat{29 * r, 6 * r, 0, r};
  join_all(mesh, frame, {throat});
  const std::vector<Station> way = {
      {{-0.186, 0, 0}, 0.0100, 0.0370}, {{-0.215, 0, 0}, 0.0095, 0.0260},
      {{-0.250, 0, 0}, 0.0095, 0.0170}, {{-0.290, 0, 0}, 0.0095, 0.0130},
      {{-0.335, 0, 0}, 0.0095, 0.0125}, {{-0.360, 0, 0}, 0.0120, 0.0150},
      {{-0.400, 0, 0}, 0.0135, 0.0165}, {{-0.450, 0, 0}, 0.0135, 0.0165},
      {{-0.500, 0, 0}, 0.0140, 0.0170}, {{-0.520, 0, 0}, 0.0155, 0.0190}};
  const Loop end = sweep(mesh, rim(frame, throat), r, 6 * r, way, -Vec3::UnitZ(), 0.5, 2 * r);
  close(mesh, end, r);
  add_strings(mesh, 0, 14, 0.0165, 0.0008);
  add_strings(mesh, 1, 18, 0.0165, -0.0008);
  return without_unused_vertices(mesh);
}

}  // namespace tumble::objects
