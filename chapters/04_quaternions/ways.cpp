/// @file
/// Ways from one orientation to another: matrices, angles and quaternions mixed, and slerp.

#include <functional>
#include <utility>
#include <vector>

#include "common.hpp"
#include "parts.hpp"
#include "plane.hpp"
#include "support/plot.hpp"
#include "support/sketch.hpp"
#include "support/space_sketch.hpp"

namespace quaternions_chapter {

// ── From one orientation to another ──

namespace {

const Mat3 start = Mat3::Identity();
constexpr double whole_turn = 150 * degree;
const Mat3 goal = exp_rotation(Vec3(whole_turn * Vec3(0.3, -1, 0.25).normalized()));

/// A way from `start` at t = 0 to `goal` at t = 1. Not every step of it need be a rotation.
struct Way {
  std::string name;
  std::function<Mat3(double)> at;
};

Mat3 mix_nine(double t) { return (1 - t) * start + t * goal; }

/// Each angle the short way round.
Mat3 mix_angles(double t) {
  const Vec3 a = matrix_to_euler_angles(start, EulerSequence::zyx);
  Vec3 way = matrix_to_euler_angles(goal, EulerSequence::zyx) - a;
  for (double& angle : way) angle = std::remainder(angle, 2 * pi);
  return euler_angles_to_matrix(a + t * way, EulerSequence::zyx);
}

const std::vector<Way> ways{
    {"nine numbers mixed", mix_nine},
    {"… and repaired", [](double t) { return nearest_rotation(mix_nine(t)); }},
    {"three angles mixed", mix_angles},
    {"four numbers mixed, normalised",
     [](double t) { return to_matrix(mix_four(from_matrix(start), from_matrix(goal), t)); }},
    {"slerp", [](double t) { return to_matrix(slerp(from_matrix(start), from_matrix(goal), t)); }}};

/// Angular speed along a way [rad per unit of t].
double speed(const Way& way, double t) {
  constexpr double d = 1e-4;
  return angle_apart(nearest_rotation(way.at(t - d)), nearest_rotation(way.at(t + d))) / (2 * d);
}

}  // namespace

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

// ── Why the pace differs ──

namespace {

/// A circle with the arc and the chord between two orientations, each in eight equal parts.
void arc_and_chord(support::Sketch& sketch, double angle, const std::string& title) {
  const auto on_circle = [](double a) { return Vec2(std::sin(a), std::cos(a)); };
  std::vector<Vec2> arc;
  for (int i = 0; i <= 90; ++i) arc.push_back(on_circle(angle * (i / 90.0 - 0.5)));
  const Vec2 a = arc.front(), b = arc.back();
  sketch.curve(arc, {"c0", 2});
  sketch.curve({a, b}, {"c1", 2});
  std::vector<std::vector<Vec2>> rays;
  for (int i = 0; i <= 8; ++i) {
    const Vec2 p = a + (b - a) * i / 8.0;
    rays.push_back({Vec2(0, 0), p.normalized()});
  }
  sketch.curves(rays, {"c1", 1, 0.6});
  for (int i = 0; i <= 8; ++i) {
    const Vec2 p = a + (b - a) * i / 8.0;
    sketch.dot(p, "c1", 3.5);
    sketch.dot(p.normalized(), "c1", 3.5);
    sketch.dot(on_circle(angle * (i / 8.0 - 0.5)) * 1.05, "c0", 3.5);
  }
  sketch.dot({0, 0}, "ink", 3);
  sketch.words({0, 0}, {0, 24}, title, "ink", "middle");
}

}  // namespace

std::string chord_figure() {
  support::Sketch sketch(520, 250, "Equal parts of the chord, unequal parts of the arc", 14);
  sketch.look({130, 200, 122});
  arc_and_chord(sketch, whole_turn / 2, "four numbers: 75° apart");
  sketch.look({390, 200, 122});
  arc_and_chord(sketch, whole_turn, "nine numbers: 150° apart");
  sketch.words({0, 0}, {-380, -180}, "equal parts of the arc", "c0");
  sketch.words({0, 0}, {-380, -162}, "equal parts of the chord, and where they point", "c1");
  return sketch.svg();
}

std::string pace_figure() {
  support::Plot plot{"pace on the way", {"t"}, {"angular speed [150° per unit of t]"}, {}};
  // In the colours of the tracks on the globe.
  const std::vector<std::pair<std::size_t, std::string>> shown{
      {4, "slerp"}, {1, "nine numbers"}, {3, "four numbers"}, {2, "three angles"}};
  for (const auto& [w, name] : shown) {
    support::Series series{name, {}, {}};
    for (int i = 0; i <= 100; ++i) {
      series.x.push_back(i / 100.0);
      series.y.push_back(speed(ways[w], i / 100.0) / whole_turn);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

Table pace_table() {
  Table table({"turn", "four: fastest / slowest", "off by", "nine: fastest / slowest", "off by"});
  const Quat a = Quat::Identity();
  for (const double angle : {5., 30., 90., 150., 179.}) {
    const Quat b = from_axis_angle({2, -1, 2}, angle * degree);
    double off_four = 0, off_nine = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = i / 1000.0;
      const Quat exact = slerp(a, b, t);
      const Mat3 nine = nearest_rotation((1 - t) * to_matrix(a) + t * to_matrix(b));
      off_four = std::max(off_four, angle_between(exact, mix_four(a, b, t)));
      off_nine = std::max(off_nine, angle_apart(to_matrix(exact), nine));
    }
    const auto ratio = [](double between) { return number(1 / std::pow(std::cos(between), 2), 5); };
    table.add({number(angle) + "°", ratio(angle * degree / 4), degrees(off_four, 2),
               ratio(angle * degree / 2), degrees(off_nine, 2)});
  }
  return table;
}

}  // namespace quaternions_chapter
