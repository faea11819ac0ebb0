/// @file
/// What a formula cannot show: the way of the numbers through dydt, a point in two frames, and L as
/// the world and the body see it.

#include "common.hpp"
#include "mug_drawing.hpp"
#include "parts.hpp"
#include "support/flow_sketch.hpp"
#include "support/space_sketch.hpp"

namespace rigid_body_chapter {

using support::Pen, support::Sketch, support::box, support::flow;

// ── The machine ──

std::string machine_figure() {
  Sketch sketch(760, 372,
                "The right-hand side of a rigid body, from thirteen numbers to their rates", 15);
  sketch.look({0, 372, 1});
  box(sketch, {40, 306}, {720, 356}, "solver: knows columns of numbers, and nothing of bodies",
      "9.5 simulate", "c0");
  sketch.frame({16, 92}, {744, 262}, {"c1", 1.8, 1, 0.04});
  sketch.words({380, 262}, {0, 22}, "9.4 dydt", "c1", "middle");
  const std::array<std::array<std::string, 2>, 4> boxes{std::array<std::string, 2>{"unpack", "9.2"},
                                                        {"derived", "9.3"},
                                                        {"wrench", "5.4"},
                                                        {"pack", "9.1"}};
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = 44 + 190. * static_cast<double>(i);
    box(sketch, {x, 142}, {x + 102, 202}, boxes[i][0], boxes[i][1], i == 2 ? "c2" : "c1");
  }
  flow(sketch, {95, 306}, {95, 204}, {8, 24}, "t, y", "start");
  flow(sketch, {665, 204}, {665, 304}, {-8, 24}, "ẏ", "end");
  flow(sketch, {148, 172}, {232, 172}, {0, -8}, "x, q, P, L");
  flow(sketch, {338, 172}, {422, 172}, {0, -8}, "R, v, ω");
  flow(sketch, {528, 172}, {612, 172}, {0, -8}, "F, τ");
  sketch.curve({{285, 142}, {285, 116}, {665, 116}}, {"ink", 1.8});
  sketch.arrow({665, 116}, {665, 140}, {"ink", 1.8});
  sketch.words({296, 116}, {0, 18}, "v and ½⟨0, ω⟩ q", "ink");
  flow(sketch, {252, 44}, {252, 140}, {0, 66}, "the body: m, I_body");
  flow(sketch, {475, 44}, {475, 140}, {0, 66}, "the scene: weight, springs, drag");
  return sketch.svg();
}

// ── A point in two frames ──

namespace {

/// From a little above, x to the right, y to the left and back, z up.
Mat3 view_from_the_front() { return support::view_from(-112 * degree, 20 * degree); }

}  // namespace

std::string frames_figure() {
  Sketch sketch(760, 290,
                "A point of the mug, from the world's origin and from its centre of mass");
  sketch.look({110, 246, 1750});
  const Mat3 view = view_from_the_front();
  Derived<> now;
  now.x = Vec3(0.24, 0.03, 0.01);
  now.R = exp_rotation(Vec3(0, -0.45, 0)) * exp_rotation(Vec3(0, 0, -0.1));
  const Vec3 p = point_position<double>(now, spring.p_body);
  const auto seen = [&view](const Vec3& point) -> Vec2 { return (view * point).head<2>(); };
  draw_mug(sketch, view, now, {"faint", 1.5});
  sketch.arrow({0, 0}, seen(now.x), {"c0", 2.4});
  sketch.words(seen(0.72 * now.x), {0, 24}, "x", "c0", "middle");
  sketch.arrow(seen(now.x), seen(p), {"c1", 2.4});
  sketch.words(seen((now.x + p) / 2), {46, 36}, "R p_body", "c1", "start");
  sketch.arrow({0, 0}, seen(p), {"c3", 2.4});
  sketch.words(seen(0.56 * p), {-10, -10}, "p = x + R p_body", "c3", "end");
  support::SpaceSketch space(sketch, view);
  const support::Pen ink{"ink", 1.8}, green{"c2", 1.8};
  space.axes(Vec3::Zero(), 0.07 * Mat3::Identity(), {"x_world", "y_world", "z_world"},
             {ink, ink, ink});
  space.axes(now.x, 0.075 * now.R, {"x_body", "y_body", "z_body"}, {green, green, green});
  sketch.dot(seen(p), "ink", 4);
  return sketch.svg();
}

// ── L in the world and in the body ──

namespace {

Vec2 turned(const Vec2& v, double angle) {
  return {std::cos(angle) * v.x() - std::sin(angle) * v.y(),
          std::sin(angle) * v.x() + std::cos(angle) * v.y()};
}

/// A plate, turned by an angle, with one of its axes.
void draw_plate(Sketch& sketch, double angle, double opacity) {
  std::vector<Vec2> corners;
  for (const Vec2& corner : {Vec2(-0.8, -0.4), {0.8, -0.4}, {0.8, 0.4}, {-0.8, 0.4}, {-0.8, -0.4}})
    corners.push_back(turned(corner, angle));
  sketch.curve(corners, {"c2", 1.8, opacity, 0.08});
  sketch.curve({{0, 0}, turned({0.8, 0}, angle)}, {"c2", 1.8, opacity});
}

}  // namespace

std::string seen_figure() {
  Sketch sketch(760, 300, "The same angular momentum, seen from the world and from the body");
  const Vec2 L = turned({1.25, 0}, 65 * degree);
  const std::array<double, 3> opacity{0.3, 0.55, 1}, angle{0, 24 * degree, 48 * degree};
  sketch.look({190, 160, 100});
  for (std::size_t i = 0; i < 3; ++i) draw_plate(sketch, angle[i], opacity[i]);
  sketch.arrow({0, 0}, L, {"c0", 2.6});
  sketch.words(L, {10, 4}, "L", "c0");
  sketch.words({0, -1}, {0, 24}, "in the world: the body turns", "ink", "middle");
  sketch.look({570, 160, 100});
  draw_plate(sketch, 0, 1);
  for (std::size_t i = 0; i < 3; ++i)
    sketch.arrow({0, 0}, turned(L, -angle[i]), {"c0", 2.6, opacity[i]});
  sketch.words(turned(L, -angle[2]), {10, 4}, "L_body", "c0");
  sketch.words({0, -1}, {0, 24}, "in the body: L turns", "ink", "middle");
  return sketch.svg();
}

}  // namespace rigid_body_chapter
