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

// ── Tracks of the nose on a globe ──

namespace {

/// The part of a curve in space that is in front of the globe's middle plane, or behind it.
std::vector<std::vector<Vec2>> seen(const std::vector<Vec3>& curve, bool front) {
  std::vector<std::vector<Vec2>> pieces;
  bool down = false;
  for (const Vec3& p : curve) {
    if ((p.z() >= 0) == front) {
      if (!down) pieces.emplace_back();
      pieces.back().emplace_back(p.head<2>());
    }
    down = (p.z() >= 0) == front;
  }
  return pieces;
}

const Mat3 globe = axis_rotation(0, -60 * degree) * axis_rotation(2, 20 * degree);

void draw_globe(support::Sketch& sketch) {
  const auto ring = [&](auto&& point) {
    std::vector<Vec3> curve;
    for (int i = 0; i <= 90; ++i) curve.emplace_back(globe * point(4 * i * degree));
    sketch.curves(seen(curve, true), {"grid", 1.2});
  };
  for (const double latitude : {-60., -30., 0., 30., 60.}) {
    const double c = std::cos(latitude * degree), s = std::sin(latitude * degree);
    ring([&](double a) { return Vec3(c * std::cos(a), c * std::sin(a), s); });
  }
  for (int i = 0; i < 6; ++i) {
    const double c = std::cos(30 * i * degree), s = std::sin(30 * i * degree);
    ring([&](double a) { return Vec3(c * std::cos(a), s * std::cos(a), std::sin(a)); });
  }
  std::vector<Vec2> rim;
  for (int i = 0; i <= 90; ++i)
    rim.emplace_back(std::cos(4 * i * degree), std::sin(4 * i * degree));
  sketch.curve(rim, {"faint", 1.2});
}

}  // namespace

std::string tracks_figure() {
  support::Sketch sketch(520, 520, "Where the nose points on the way", 14);
  sketch.look({260, 215, 200});
  draw_globe(sketch);
  const std::array<std::string, 5> colours{"c1", "", "c3", "c2", "c0"};
  double line = 208;
  for (const std::size_t w : {0u, 2u, 3u, 4u}) {
    std::vector<Vec3> curve;
    for (int i = 0; i <= 160; ++i) curve.emplace_back(globe * ways[w].at(i / 160.0).col(0));
    sketch.curves(seen(curve, false), {colours[w], 2, 0.35});
    sketch.curves(seen(curve, true), {colours[w], 2});
    for (int i = 0; i <= 8; ++i)
      sketch.dot(globe.topRows<2>() * ways[w].at(i / 8.0).col(0), colours[w], 3.5);
    sketch.words({0, 0}, {-250, line += 18}, ways[w].name, colours[w]);
  }
  sketch.look({470, 480, 1});
  support::SpaceSketch(sketch, globe).world_axes(Vec3::Zero(), 32);
  return sketch.svg();
}

}  // namespace quaternions_chapter
