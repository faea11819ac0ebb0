/// @file
/// Figure 4.6, and what a reader can move in it: the orientation to which four ways lead.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "04_quaternions/moving_figures.hpp"
#include "04_quaternions/plane.hpp"
#include "support/space_sketch.hpp"
#include "tumble/quaternion/slerp.hpp"

namespace quaternions_chapter::tracks_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::Vec2;

enum Which { angle, around, above, time };
constexpr double film = 4;  // from one orientation to the other [s]
constexpr std::array<Control, 4> controls{
    {{"angle", "turned by", "°", 0, 360, 0.1, 150},
     {"around", "the axis points", "°", -180, 180, 0.1, -73.3},
     {"above", "and up by", "°", -90, 90, 0.1, 13.5},
     {"t", "time", "s", 0, film, 0.02, 1.2}}};

/// The orientations between which the ways lead. b may be on the other half of its sphere.
const Quat a = Quat::Identity();

Quat goal(Settings now) {
  const double up = now[above] * degree, round = now[around] * degree;
  const Vec3 axis(std::cos(up) * std::cos(round), std::cos(up) * std::sin(round), std::sin(up));
  return from_axis_angle(axis, now[angle] * degree);
}

struct Way {
  const char *name, *colour;
  Mat3 (*at)(const Quat& b, double t);
};

constexpr std::array<Way, 4> ways{
    {{"nine numbers", "c1",
      [](const Quat& b, double t) { return mix_nine(to_matrix(a), to_matrix(b), t); }},
     {"three angles", "c3",
      [](const Quat& b, double t) { return mix_angles(to_matrix(a), to_matrix(b), t); }},
     {"four numbers", "c2", [](const Quat& b, double t) { return to_matrix(mix_four(a, b, t)); }},
     {"slerp", "c0", [](const Quat& b, double t) { return to_matrix(slerp(a, b, t)); }}}};

// ── Tracks of the nose on a globe ──

const Mat3& globe() {
  static const Mat3 view = axis_rotation(0, -60 * degree) * axis_rotation(2, 20 * degree);
  return view;
}

std::vector<Vec2> circle(double from, double to) {
  std::vector<Vec2> line;
  const int parts = std::max(1, static_cast<int>(std::abs(to - from) / (4 * degree)));
  for (int i = 0; i <= parts; ++i) {
    const double at = from + (to - from) * i / parts;
    line.emplace_back(std::cos(at), std::sin(at));
  }
  return line;
}

void draw_globe(support::Sketch& sketch) {
  const auto ring = [&](auto&& point) {
    support::Way line{{}, {"grid", 1.2}};
    for (int i = 0; i <= 60; ++i) line.points.emplace_back(point(6 * i * degree));
    sketch.curves(support::visible(line, globe(), true), line.pen);
  };
  for (const double latitude : {-60., -30., 0., 30., 60.}) {
    const double c = std::cos(latitude * degree), s = std::sin(latitude * degree);
    ring([&](double at) { return Vec3(c * std::cos(at), c * std::sin(at), s); });
  }
  for (int i = 0; i < 6; ++i) {
    const double c = std::cos(30 * i * degree), s = std::sin(30 * i * degree);
    ring([&](double at) { return Vec3(c * std::cos(at), s * std::cos(at), std::sin(at)); });
  }
  sketch.curve(circle(0, 2 * pi), {"faint", 1.2});
}

void draw_track(support::Sketch& sketch, const Way& way, const Quat& b, double t) {
  constexpr int parts = 96;
  const std::string colour = way.colour;
  support::Way track{{}, {colour, 2}};
  for (int i = 0; i <= parts; ++i) track.points.emplace_back(way.at(b, 1. * i / parts).col(0));
  sketch.curves(support::visible(track, globe(), false), {colour, 2, 0.35});
  sketch.curves(support::visible(track, globe(), true), track.pen);
  std::vector<Vec2> eighths;
  for (int i = 0; i <= 8; ++i)
    eighths.emplace_back(
        (globe() * track.points[static_cast<std::size_t>(parts / 8 * i)]).head<2>());
  sketch.dots(eighths, colour, 3);
  sketch.dot((globe() * way.at(b, t).col(0)).head<2>(), colour, 6.5);
}

void draw_tracks(support::Sketch& sketch, const Quat& b, double t) {
  constexpr double globe_radius = 188;  // [px]
  sketch.look({220, 205, globe_radius});
  draw_globe(sketch);
  for (const Way& way : ways) draw_track(sketch, way, b, t);
  const auto seen = [](const Quat& q) -> Vec2 { return (globe() * to_matrix(q).col(0)).head<2>(); };
  const bool apart = (seen(b) - seen(a)).norm() * globe_radius > 50;
  if (apart) {
    sketch.words(seen(a), {10, -8}, "start");
    sketch.words(seen(b), {10, -8}, "end");
  } else {
    sketch.words(seen(a), {-12, -8}, "start, end", "ink", "end");
  }
  sketch.grip({{0, 0}}, globe_radius);
  sketch.look({38, 385, 1});
  support::SpaceSketch(sketch, globe()).world_axes(Vec3::Zero(), 30);
}

// ── The circle of quaternions through a and b ──

std::string where_to(double cosine) {
  constexpr double rounding = 1e-12;
  if (std::abs(cosine) < rounding) return "quaternions: b and −b are equally far";
  return cosine < 0 ? "quaternions: −b is nearer than b" : "quaternions: b is nearer than −b";
}

void draw_circle(support::Sketch& sketch, const Quat& b, double half, double t) {
  sketch.look({590, 190, 110});
  sketch.curve(circle(0, 2 * pi), {"faint", 1.2});
  const bool other = a.dot(b) < 0;  // slerp then goes to −b
  const double end = other ? half - pi : half;
  const auto at = [](double angle) -> Vec2 { return {std::cos(angle), std::sin(angle)}; };
  sketch.curve({at(half), at(half + pi)}, {"grid", 1.5});
  sketch.curve({at(0), at(end)}, {"c2", 2});
  sketch.curve(circle(0, end), {"c0", 3});
  sketch.dot((1 - t) * at(0) + t * at(end), "c2", 5.5);
  sketch.dot(at(t * end), "c0", 5.5);
  sketch.dots({at(0), at(half), at(half + pi)}, "ink", 4);
  const auto name = [&](double angle, const std::string& text) {
    sketch.words(1.15 * at(angle), {0, 6}, text, "ink", "middle");
  };
  constexpr double near = 15 * degree;  // two names would be on each other
  const bool with_b = half < near;
  const bool with_other = half > pi - near;
  if (with_b || with_other)
    sketch.words(at(0), {10, 6}, with_b ? "a, b" : "a, −b");
  else
    name(0, "a");
  if (!with_b) name(half, "b");
  if (!with_other) name(half + pi, "−b");
  sketch.words({0, -1}, {0, 44}, where_to(a.dot(b)), "ink", "middle");
  sketch.words({0, -1}, {0, 66}, "Ω = " + support::svg_number(std::abs(end) / degree, 1) + "°",
               "ink", "middle");
}

// ── The plane, by each way ──

void draw_plane(support::Sketch& sketch, const Mat3& now, const support::Placement& place) {
  static const PolygonMesh mesh = paper_plane();
  // Its keel shows where it is when nothing else is left of it.
  const Mat3 seen = viewer * now;
  sketch.look({place.x, place.y, place.scale});
  sketch.curve({(seen * mesh.vertices[0]).head<2>(), (seen * mesh.vertices[5]).head<2>()},
               {"faint", 1.5});
  constexpr double crushed = 1e-9;
  if (now.determinant() > crushed) sketch.drawing(support::draw_mesh(mesh, seen, place));
}

void draw_planes(support::Sketch& sketch, const Quat& b, double t) {
  double x = 95;
  for (const Way& way : ways) {
    const Mat3 now = way.at(b, t);
    draw_plane(sketch, now, {x, 505, 105});
    sketch.look({x, 598, 1});
    sketch.words({0, 0}, {0, 0}, way.name, way.colour, "middle");
    sketch.words({0, 0}, {0, 22}, "volume " + support::svg_number(now.determinant(), 3), "ink",
                 "middle");
    x += 190;
  }
}

std::string draw(Settings now) {
  const Quat b = goal(now);
  const double t = now[time] / film;
  support::Sketch sketch(760, 634, "Four ways from one orientation to another", 17);
  draw_tracks(sketch, b, t);
  draw_circle(sketch, b, now[angle] / 2 * degree, t);
  draw_planes(sketch, b, t);
  return sketch.svg();
}

/// Turns the end as a ball would turn under the pointer.
void drag(std::span<double> settings, const Drag& pointer) {
  constexpr double per_pixel = 0.5 * degree;
  const Vec3 turn = globe().transpose() * Vec3(per_pixel * pointer.dy, per_pixel * pointer.dx, 0);
  const Quat b = exp_quaternion<double>(turn) * goal(settings);
  const double sine = b.vec().norm();
  settings[angle] = allowed(controls[angle], 2 * std::atan2(sine, b.w()) / degree);
  if (sine == 0) return;
  settings[around] = allowed(controls[around], std::atan2(b.y(), b.x()) / degree);
  settings[above] = allowed(controls[above], std::asin(std::clamp(b.z() / sine, -1., 1.)) / degree);
}

}  // namespace
}  // namespace quaternions_chapter::tracks_figure

const tumble::support::MovingFigure tumble::figures::tracks{
    "tracks", quaternions_chapter::tracks_figure::controls,
    quaternions_chapter::tracks_figure::draw, quaternions_chapter::tracks_figure::drag,
    quaternions_chapter::tracks_figure::time};
