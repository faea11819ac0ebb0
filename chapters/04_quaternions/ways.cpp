/// @file
/// Ways from one orientation to another: matrices, angles and quaternions mixed, and slerp.

#include <vector>

#include "parts.hpp"
#include "plane.hpp"
#include "support/sketch.hpp"
#include "support/space_sketch.hpp"
#include "ways.hpp"

namespace quaternions_chapter {

Table ways_table() {
  Table table({"way", "turns in all", "fastest / slowest", "smallest volume"});
  constexpr int parts = 400;
  for (const Way& way : ways) {
    double turned = 0, fastest = 0, slowest = 1e9, volume = 1;
    for (int i = 0; i <= parts; ++i) {
      const double t = 1.0 * i / parts, v = speed(way, t);
      turned += v / parts * (i == 0 || i == parts ? 0.5 : 1);
      fastest = std::max(fastest, v);
      slowest = std::min(slowest, v);
      volume = std::min(volume, way.at(t).determinant());
    }
    table.add({way.name, degrees(turned), number(fastest / slowest, 3), number(volume, 3)});
  }
  return table;
}

std::string between_figure() {
  constexpr double cell = 104, row = 150;
  support::Sketch sketch(5 * cell, 3 * row + 44, "From one orientation to another", 14);
  std::string planes;
  const PolygonMesh mesh = paper_plane();
  double y = 0;
  for (const std::size_t w : {0u, 2u, 4u}) {
    sketch.words({0, 0}, {8, y + 18}, ways[w].name);
    for (int i = 0; i < 5; ++i) {
      const Mat3 R = ways[w].at(i / 4.0);
      const double x = cell * (i + 0.5);
      planes += support::draw_mesh(mesh, viewer * R, {x, y + 76, 82});
      const std::string volume = "volume " + number(R.determinant(), 2);
      sketch.words({0, 0}, {x, y + 138}, w == 0 ? volume : "t = " + number(i / 4.0), "ink",
                   "middle");
    }
    y += row;
  }
  sketch.look({26, y + 32, 1});
  support::SpaceSketch(sketch, viewer).world_axes(Vec3::Zero(), 22);
  return with_planes(sketch, planes);
}

}  // namespace quaternions_chapter
