/// @file
/// Arrows: what both factors of q p q⁻¹ do to a point, and the arc from one quaternion to another.

#include "common.hpp"
#include "parts.hpp"
#include "support/space_sketch.hpp"

namespace quaternions_chapter {

namespace {

using support::Pen, support::Sketch, support::SpaceSketch;

Vec2 on_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

std::vector<Vec2> arc_from(double begin, double end, double radius) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 40; ++i)
    points.emplace_back(radius * on_circle(begin + (end - begin) * i / 40));
  return points;
}

/// A point of space with its parts along the axis and perpendicular to it, before and after.
void draw_point_and_axis(Sketch& sketch, double half) {
  const Mat3 view = support::view_from(-70 * degree, 24 * degree);
  sketch.look({215, 320, 100});
  SpaceSketch space(sketch, view);
  const Vec3 u = Vec3::UnitZ(), along = 1.7 * u;
  const Vec3 before = 1.5 * Vec3(std::cos(-0.4), std::sin(-0.4), 0);
  const Vec3 after = axis_rotation(2, 2 * half) * before;
  space.curve({-0.2 * u, 2.75 * u}, {"faint", 1.2});
  space.curve(support::arc(along, before, u, 2 * pi), {"faint", 1.4});
  space.arrow(Vec3::Zero(), u, {"c3", 3});
  space.words(0.55 * u, {-14, 4}, "u", "c3", "end");
  space.arrow(along, along + before, {"c1", 2.2});
  space.words(along + 0.6 * before, {14, -6}, "p⊥", "c1", "start");
  space.arrow(along, along + after, {"c2", 2.2});
  space.arrow(Vec3::Zero(), along + before, {"ink", 2});
  space.words(0.55 * (along + before), {12, 14}, "p", "ink", "start");
  space.arrow(Vec3::Zero(), along + after, {"c2", 2});
  space.words(along + after, {10, -10}, "q p q⁻¹", "c2", "start");
  space.dot(along + before, "ink", 4.5);
  space.dot(along + after, "c2", 4.5);
  sketch.look({46, 352, 1});
  SpaceSketch(sketch, view).world_axes(Vec3::Zero(), 36);
}

/// The circle of the other panel, seen along the axis.
void draw_from_above(Sketch& sketch, double half) {
  sketch.look({580, 205, 120});
  sketch.curve(arc_from(0, 2 * pi, 1), {"faint", 1.4});
  const double begin = -0.35;
  const std::array<const char*, 3> colours{"c1", "c4", "c2"};
  const std::array<std::string, 3> names{"p⊥", "q p⊥", "q p⊥ q⁻¹"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 tip = on_circle(begin + static_cast<double>(i) * half);
    sketch.arrow({0, 0}, tip, {colours[i], 2.4});
    sketch.words(tip, {9 * tip.x() - (i == 2 ? 8 : 0), 6 - 14 * tip.y()}, names[i], colours[i],
                 i == 2 ? "middle" : "start");
  }
  for (int i = 0; i < 2; ++i) {
    sketch.curve(arc_from(begin + i * half, begin + (i + 1) * half, 0.42), {"ink", 1.4});
    sketch.words(0.56 * on_circle(begin + (i + 0.5) * half), {0, 5}, "α", "ink", "middle");
  }
  sketch.dot({0, 0}, "c3", 4.5);
  sketch.words({0, 0}, {-10, 20}, "u", "c3", "end");
}

}  // namespace

std::string turn_figure() {
  Sketch sketch(760, 400, "A point turned by q p q⁻¹: its part along the axis stays", 17);
  constexpr double half = 50 * degree;
  draw_point_and_axis(sketch, half);
  draw_from_above(sketch, half);
  return sketch.svg();
}

std::string arc_figure() {
  Sketch sketch(760, 400, "Slerp goes along the arc from a to b", 18);
  constexpr double whole = 75 * degree, t = 0.6, weight = 1 / 0.9659258;  // 1/sin 75°
  const Vec2 a(1, 0), b = on_circle(whole), q = on_circle(t * whole);
  sketch.look({240, 340, 290});
  sketch.curve(arc_from(-0.12, 100 * degree, 1), {"grid", 2});
  sketch.curve(arc_from(0, whole, 1), {"c0", 2.6});
  sketch.curve({a, b}, {"faint", 1.4});
  sketch.arrow({0, 0}, {0, 1}, {"c3", 2});
  sketch.words({0, 1}, {-12, 4}, "e", "c3", "end");
  sketch.arrow({0, 0}, a, {"ink", 2.6});
  sketch.words(a, {14, 6}, "a");
  sketch.arrow({0, 0}, b, {"ink", 2.6});
  sketch.words(b, {8, -12}, "b");
  sketch.arrow({0, 0}, q, {"c0", 2.6});
  sketch.words(q, {12, -4}, "q(t)", "c0");
  const Vec2 part_a = weight * std::sin((1 - t) * whole) * a;
  sketch.arrow({0, 0}, part_a, {"c1", 3});
  sketch.words(part_a / 2, {0, 26}, "along a", "c1", "middle");
  sketch.arrow(part_a, q, {"c1", 3});
  sketch.words((part_a + q) / 2, {12, 14}, "along b", "c1");
  sketch.curve(arc_from(0, t * whole, 0.17), {"c0", 1.6});
  sketch.words(0.23 * on_circle(0.4 * t * whole), {0, 5}, "tΩ", "c0", "middle");
  sketch.curve(arc_from(0, whole, 0.32), {"ink", 1.4});
  sketch.words(0.37 * on_circle(0.87 * whole), {0, 5}, "Ω", "ink", "middle");
  sketch.dot(q, "c0", 5);
  sketch.words({0.5, -0.08}, {0, 30}, "the plane of a and b, in four dimensions", "faint",
               "middle");
  return sketch.svg();
}

}  // namespace quaternions_chapter
