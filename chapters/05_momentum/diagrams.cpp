/// @file
/// What a formula cannot show: a point in two frames, and an arm with a force and its torque.

#include "common.hpp"
#include "objects/racket_lines.hpp"
#include "parts.hpp"
#include "support/space_sketch.hpp"
#include "thrown_objects.hpp"

namespace momentum_chapter {

namespace {

using support::Pen, support::Sketch, support::SpaceSketch;

void draw_racket_in_space(SpaceSketch& space, const Derived<>& now, const Vec3& centre) {
  const objects::RacketLines lines = objects::racket_lines();
  const auto draw = [&](const std::vector<std::vector<Vec3>>& part, const Pen& pen) {
    for (const std::vector<Vec3>& line : part) {
      std::vector<Vec3> points;
      for (const Vec3& p : line) points.push_back(point_position<double>(now, p - centre));
      space.curve(points, pen);
    }
  };
  draw(lines.strings, {"faint", 0.6});
  draw(lines.frame, {"faint", 2});
  draw(lines.throat, {"faint", 2});
  draw(lines.handle, {"faint", 4});
}

/// The body's axes, with their names where the racket leaves room.
void draw_body_axes(SpaceSketch& space, const Derived<>& now, double length) {
  const std::array<std::string, 3> names{"x_body", "y_body", "z_body"};
  const std::array<Vec2, 3> offsets{Vec2(8, 12), {-14, -8}, {8, -2}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 tip = now.x + length * now.R.col(static_cast<Eigen::Index>(i));
    space.arrow(now.x, tip, {"c2", 1.8});
    space.words(tip, offsets[i], names[i], "c2", "start");
  }
}

}  // namespace

std::string frames_figure() {
  Sketch sketch(760, 420,
                "A point of a racket, from the world's origin and from its centre of mass");
  sketch.look({100, 350, 480});
  SpaceSketch space(sketch, support::view_from(-105 * degree, 20 * degree));
  const Vec3 centre = properties_of(racket).centre, p_body = Vec3(-0.52, 0, 0) - centre;
  Derived<> now;
  now.x = Vec3(0.86, 0.1, 0.28);
  now.R = exp_rotation(Vec3(0, 0.5, 0)) * exp_rotation(Vec3(0.5, 0, 0));
  const Vec3 p = point_position<double>(now, p_body), origin = Vec3::Zero();
  draw_racket_in_space(space, now, centre);
  space.world_axes(origin, 0.22);
  space.words(origin, {-8, 24}, "world");
  draw_body_axes(space, now, 0.24);
  space.arrow(origin, now.x, {"c0", 2.4});
  space.words(0.6 * now.x, {0, 26}, "x", "c0");
  space.arrow(now.x, p, {"c1", 2.4});
  space.words((now.x + p) / 2, {-4, 28}, "R p_body", "c1", "end");
  space.arrow(origin, p, {"c3", 2.4});
  space.words(0.6 * p, {-10, -12}, "p = x + R p_body", "c3", "end");
  space.dot(p, "ink", 4);
  space.dot(now.x, "ink", 4);
  return sketch.svg();
}

std::string torque_figure() {
  Sketch sketch(760, 380, "Arm, force and torque of a force on a flat body");
  const Mat3 view = support::view_from(-75 * degree, 32 * degree);
  sketch.look({300, 250, 118});
  SpaceSketch space(sketch, view);
  std::vector<Vec2> outline;
  for (int i = 0; i <= 60; ++i) {
    const double at = 6 * i * degree;
    outline.push_back(
        space.seen(Vec3((2.15 + 0.2 * std::cos(3 * at)) * std::cos(at), 1.25 * std::sin(at), 0)));
  }
  sketch.curve(outline, {"faint", 1.8, 1, 0.12});
  const Vec3 x = Vec3::Zero(), p(1.75, 0.1, 0), F(0.75, 1.5, 0), along = F.normalized();
  space.curve({p - 1.3 * along, p + 3 * along}, {"faint", 1.4});
  space.curve({p, 1.45 * p}, {"faint", 1.4});
  space.arrow(x, p, {"c0", 2.6});
  space.words(0.5 * p, {0, 24}, "r = p − x", "c0");
  space.arrow(p, p + F, {"c1", 2.8});
  space.words(p + 0.75 * F, {14, 8}, "F", "c1", "start");
  space.arrow(x, Vec3(0, 0, 1.7), {"c3", 2.8});
  space.words(Vec3(0, 0, 1.7), {14, 10}, "τ = r × F", "c3", "start");
  const double theta = std::acos(p.normalized().dot(along));
  space.curve(support::arc(p, 0.45 * p.normalized(), Vec3::UnitZ(), theta), {"ink", 1.4});
  space.words(p + Vec3(0.52, 0.28, 0), {6, 4}, "θ", "ink", "start");
  space.dot(x, "ink", 5);
  space.words(x, {-12, 8}, "x", "ink", "end");
  space.dot(p, "ink", 4.5);
  space.words(p, {2, 24}, "p");
  sketch.look({60, 340, 1});
  SpaceSketch(sketch, view).world_axes(Vec3::Zero(), 46);
  return sketch.svg();
}

}  // namespace momentum_chapter
