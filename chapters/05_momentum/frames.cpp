/// @file
/// A point of a body: what is in whose axes, and how fast which point moves.

#include <cmath>

#include "common.hpp"
#include "parts.hpp"

namespace momentum_chapter {

Table forgotten_table() {
  Table table({"body turned by", "v + ω × (R p_body)", "v + ω × p_body", "off by"});
  const Vec3 p_body(0.5, 0, 0), v(1, 0, 0), omega(0, 0, 4);
  for (const double turned : {0., 10., 90., 180.}) {
    const Derived<> now{Vec3::Zero(), exp_rotation(Vec3(0, 0, turned * degree)), v, omega};
    const Vec3 right = point_velocity(now, p_body), wrong = v + omega.cross(p_body);
    const auto text = [](const Vec3& u) {
      return "(" + support::svg_number(u.x(), 2) + ", " + support::svg_number(u.y(), 2) + ") m/s";
    };
    table.add({number(turned) + "°", text(right), text(wrong),
               support::svg_number((right - wrong).norm(), 2) + " m/s"});
  }
  return table;
}

// ── A wheel of a train ──

namespace {

constexpr double tread = 0.46, flange = 0.028;  // radius of the wheel, height of its flange [m]
constexpr double train = 300 / 3.6;             // [m/s]

/// x forward, z up: a wheel that rolls turns clockwise, about y.
Derived<> rolling(double radius, double speed, double t = 0) {
  const Vec3 v(speed, 0, 0), omega(0, speed / radius, 0);
  return {t * v, exp_rotation(Vec3(t * omega)), v, omega};
}

Vec2 forward_and_up(const Vec3& p) { return {p.x(), p.z()}; }

}  // namespace

Table wheel_table() {
  Table table({"point of the wheel", "forward [km/h]", "upward [km/h]"});
  const Derived<> wheel = rolling(tread, train);
  const auto add = [&](const std::string& name, const Vec3& p) {
    const Vec3 velocity = 3.6 * point_velocity(wheel, p);
    table.add({name, support::svg_number(velocity.x(), 1), support::svg_number(velocity.z(), 1)});
  };
  add("its axle", Vec3::Zero());
  add("the highest of the tread", {0, 0, tread});
  add("the foremost of the tread", {tread, 0, 0});
  add("where it touches the rail", {0, 0, -tread});
  add("the lowest of the flange", {0, 0, -tread - flange});
  return table;
}

std::string wheel_figure() {
  support::Sketch sketch(760, 380, "How the points of a rolling wheel move");
  sketch.look({380, 190, 112});
  const double far = 3.3, outer = 1.2;
  std::vector<Vec2> way;
  for (int i = -130; i <= 130; ++i)
    way.push_back(forward_and_up(point_position(rolling(1, 1, i * 0.0254), Vec3(0, 0, -outer))));
  sketch.curve({{-far, -1}, {far, -1}}, {"faint", 3});
  sketch.curve(way, {"c1", 1.8});
  sketch.curve(circle({0, 0}, 1), {"ink", 2.2});
  sketch.curve(circle({0, 0}, outer), {"ink", 1.2});
  const Derived<> wheel = rolling(1, 1);
  const auto arrow = [&](const Vec3& p, const char* colour) {
    const Vec3 end = p + 0.42 * point_velocity(wheel, p);
    sketch.arrow(forward_and_up(p), forward_and_up(end), {colour, 2});
  };
  arrow(Vec3::Zero(), "c2");
  for (int i = 0; i < 12; ++i) {
    const Vec3 out(std::sin(30 * i * degree), 0, std::cos(30 * i * degree));
    if (i != 6) arrow(out, "c0");
    if (i % 2 == 0) arrow(0.5 * out, "c0");
  }
  arrow({0, 0, -outer}, "c1");
  sketch.dot({0, -1}, "c6", 5);
  sketch.words({0, -1}, {64, 23}, "at rest", "c6");
  sketch.words({0, -1}, {-64, 23}, "backwards", "c1", "end");
  return sketch.svg();
}

}  // namespace momentum_chapter
