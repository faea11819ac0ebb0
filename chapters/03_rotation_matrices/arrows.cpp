/// @file
/// Arrows: the columns of R as the axes of a mug, and a point that turns about ω.

#include "common.hpp"
#include "objects/plain_mug.hpp"
#include "parts.hpp"
#include "support/facets.hpp"

namespace rotation_matrices_chapter {

namespace {

using support::Pen, support::Sketch, support::SpaceSketch, support::Vec2;

}  // namespace

std::string columns_figure() {
  Sketch sketch(760, 360, "The columns of R are the axes of the mug", 18);
  const Mat3 R = paper_rotation(), view = support::view_from(-8 * degree, 18 * degree);
  const support::Window window{250, 180, 1500};
  const Vec3 middle = view * R * Vec3(0, 0, 0.0475);
  const support::Placement placement{window.x - window.scale * middle.x(),
                                     window.y + window.scale * middle.y(), window.scale};
  sketch.drawing(support::draw_pale_facets(objects::plain_mug(), view * R, placement));
  sketch.look(window);
  SpaceSketch(sketch, view).axes(Vec3::Zero(), 0.11 * R, {"x", "y", "z"}, column_pens);
  sketch.look({60, 300, 1});
  SpaceSketch(sketch, view).world_axes(Vec3::Zero(), 46);
  sketch.words({0, 0}, {0, 56}, "world", "ink", "middle");
  draw_matrix(sketch, R, "R", {488, 170, 74, 34});
  return sketch.svg();
}

std::string cross_figure() {
  Sketch sketch(760, 400, "A point at r turns on a circle about omega", 18);
  const Mat3 view = support::view_from(-100 * degree, 22 * degree);
  sketch.look({300, 345, 102});
  SpaceSketch space(sketch, view);
  const Vec3 axis = Vec3(0.18, 0, 1).normalized(), a = 2.1 * axis;
  const Vec3 b = 1.7 * (Vec3::UnitX() - axis.x() * axis).normalized();
  const Vec3 r = a + b, omega = 0.9 * axis, rate = omega.cross(b);
  space.curve({-0.3 * axis, 3 * axis}, {"faint", 1.2});
  space.curve(support::arc(a, b, axis, 360 * degree), {"faint", 1.8});
  space.arrow(Vec3::Zero(), omega, {"c3", 3});
  space.words(0.5 * omega, {-14, 4}, "ω", "c3", "end");
  space.arrow(Vec3::Zero(), a, {"c0", 1.6});
  space.words(0.8 * a, {-14, 4}, "a", "c0", "end");
  space.arrow(a, r, {"c1", 2.4});
  space.words(a + 0.5 * b, {0, 24}, "b", "c1");
  space.arrow(Vec3::Zero(), r, {"ink", 2.4});
  space.words(0.55 * r, {14, 18}, "r = a + b", "ink", "start");
  space.arrow(r, r + rate, {"c2", 2.6});
  space.words(r + rate, {14, -6}, "ω × b = ω × r", "c2", "start");
  space.dot(r, "ink", 5);
  space.dot(Vec3::Zero(), "ink", 4);
  sketch.look({70, 380, 1});
  SpaceSketch(sketch, view).world_axes(Vec3::Zero(), 46);
  return sketch.svg();
}

Table turning_point_table() {
  Table table({"what", "number"});
  const Vec3 omega(0, 0, 2), r(3, 0, 4), a(0, 0, 4);
  table.add({"ω × r", in_brackets(omega.cross(r))});
  table.add({"speed |ω × r|", number(omega.cross(r).norm())});
  table.add({"|ω| |b|", number(omega.norm() * (r - a).norm())});
  table.add({"ω × r, with r = (3, 0, 100)", in_brackets(omega.cross(Vec3(3, 0, 100)))});
  return table;
}

}  // namespace rotation_matrices_chapter
