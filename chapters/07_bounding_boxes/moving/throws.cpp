/// @file
/// Figure 7.9: a racket that the reader turns in the box along the axes, and what the box's tensor
/// does to a throw.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "07_bounding_boxes/askew_box.hpp"
#include "07_bounding_boxes/moving_figures.hpp"
#include "07_bounding_boxes/racket_itself.hpp"
#include "support/box_edges.hpp"
#include "support/space_sketch.hpp"
#include "tumble/body/derived.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/quaternion/convert.hpp"
#include "tumble/rotation/euler_angles.hpp"

namespace bounding_boxes_chapter::throws_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::Sketch;
using support::svg_number;
using support::Vec2;

constexpr double film = 3, spin = 10;  // [s], [rad/s]
enum Which { time, around, up, rolled, axis };
constexpr std::array<Control, 5> controls{
    {{"t", "time", "s", 0, film, 0.02, 1},
     {"around", "turned about z by", "°", -180, 180, 1, 35},
     {"up", "head up by", "°", -90, 90, 1, 25},
     {"rolled", "rolled about its handle by", "°", -90, 90, 1, 0},
     {"axis", "spun about its", "", 0, 2, 1, 1, "easiest axis|middle axis|hardest axis"}}};

/// How the racket lies when it gets its box.
Mat3 lie(Settings now) {
  return axis_rotation(2, now[around] * degree) * axis_rotation(1, -now[up] * degree) *
         axis_rotation(0, now[rolled] * degree);
}

// ── Two throws ──

/// A free flight that begins with the chosen principal axis of the racket upright, and with a spin
/// that is a little askew.
FreeTrajectory thrown(const Mat3& inertia, int chosen) {
  constexpr double askew = 0.04;  // [rad]
  Mat3 upright;                   // from principal axes: the chosen one along z
  for (int k = 0; k < 3; ++k) upright.col(k) = Vec3::Unit((k - chosen + 5) % 3);
  const Quat q = from_matrix(Mat3(upright * racket_itself().axes.R.transpose()));
  const RigidBody<> body(racket_itself().truth.mass, inertia);
  const Vec3 omega = spin * Vec3(askew, askew, 1);
  return {body, state_of_motion<double>(body, Vec3::Zero(), q, Vec3::Zero(), omega)};
}

struct Throws {
  FreeTrajectory own, with_box;

  /// How far the two are apart [rad].
  double apart(double t) const {
    const double w = std::abs(own.at(t).q.dot(with_box.at(t).q));
    return 2 * std::acos(std::min(1., w));
  }
};

// ── The picture ──

const Mat3& view() {
  static const Mat3 from_the_right = support::view_from(-60 * degree, 20 * degree);
  return from_the_right;
}

void draw_racket(Sketch& sketch, const Mat3& R, const std::string& colour) {
  support::SpaceSketch space(sketch, view() * R);
  const auto draw = [&](const std::vector<std::vector<Vec3>>& lines, const support::Pen& pen) {
    for (const std::vector<Vec3>& line : lines) space.curve(line, pen);
  };
  const objects::RacketLines& lines = racket_itself().lines;
  draw(lines.strings, {"faint", 1});
  draw(lines.throat, {colour, 3});
  draw(lines.frame, {colour, 4});
  draw(lines.handle, {colour, 7});
}

std::string millimetres(double length) { return svg_number(1000 * length, 0); }

void draw_box(Sketch& sketch, const Mat3& R, const boxes::OrientedBox& box, double difference) {
  sketch.look({165, 180, 330});
  const Mat3 edges = box.size.asDiagonal();
  draw_racket(sketch, R, "c0");
  sketch.curves(support::box_edges(R * box.centre, edges, view()), {"c6", 1.8});
  sketch.grip({{0, 0}}, 120);
  sketch.look({36, 335, 1});
  support::SpaceSketch(sketch, view()).world_axes(Vec3::Zero(), 30);
  const double volume = racket_itself().truth.mass / objects::ash_wood;
  const auto line = [&](double y, const std::string& text, const std::string& colour) {
    sketch.words({165, -y}, {0, 0}, text, colour, "middle");
  };
  sketch.look({0, 0, 1});
  line(24, "turn the racket in its box", "ink");
  line(386,
       millimetres(box.size[0]) + " × " + millimetres(box.size[1]) + " × " +
           millimetres(box.size[2]) + " mm",
       "c6");
  line(410, svg_number(box.volume() / volume, 1) + " times the racket's volume", "c6");
  line(434, "its tensor's shape: off by δ = " + svg_number(difference, 3), "c6");
}

/// The racket in flight, and the axis that it was spun about.
void draw_throw(Sketch& sketch, const Mat3& R, int chosen, double x, const std::string& colour,
                const std::string& name) {
  constexpr double reach = 0.33;  // [m]
  sketch.look({x, 200, 315});
  draw_racket(sketch, R, colour);
  support::SpaceSketch(sketch, view())
      .arrow(Vec3::Zero(), reach * (R * racket_itself().axes.R.col(chosen)), {"ink", 1.8});
  sketch.look({0, 0, 1});
  sketch.words({x, -24}, {0, 0}, name, colour, "middle");
}

// ── How far they are apart, over time ──

constexpr double left = 66, bottom = 606, per_second = 205, per_degree = 0.62;

Vec2 in_plot(double t, double angle) {
  return {left + per_second * t, -bottom + per_degree * angle / degree};
}

void draw_apart(Sketch& sketch, const Throws& both, double t, double difference) {
  constexpr int parts = 120;
  for (const int angle : {0, 90, 180}) {
    sketch.curve({in_plot(0, angle * degree), in_plot(film, angle * degree)}, {"grid", 1});
    sketch.words(in_plot(0, angle * degree), {-8, 6}, std::to_string(angle) + "°", "ink", "end");
  }
  for (const int second : {0, 1, 2, 3})
    sketch.words(in_plot(second, 0), {0, 24}, std::to_string(second) + " s", "ink", "middle");
  const double reached = difference > 0 ? std::min(film, pi / (difference * spin)) : film;
  sketch.curve({in_plot(0, 0), in_plot(reached, difference * spin * reached)}, {"faint", 1.6});
  std::vector<Vec2> curve;
  for (int i = 0; i <= parts; ++i) {
    const double at = film * i / parts;
    curve.push_back(in_plot(at, both.apart(at)));
  }
  sketch.curve(curve, {"c6", 2});
  sketch.dot(in_plot(t, both.apart(t)), "c6", 6);
  sketch.words({left, -bottom + per_degree * 180}, {0, -14},
               "apart by " + svg_number(both.apart(t) / degree, 0) +
                   "°; grey: the estimate δ ω t, " + svg_number(difference * spin * t / degree, 0) +
                   "°");
}

std::string draw(Settings now) {
  const Racket& racket = racket_itself();
  const Mat3 R = lie(now);
  const boxes::OrientedBox box = askew_box(racket.points, R);
  const Mat3 wrong = boxes::box_mass_properties(box, racket.truth.mass).inertia;
  const double difference = shape_difference(racket.truth.inertia, wrong);
  const int chosen = static_cast<int>(now[axis]);
  const Throws both{thrown(racket.truth.inertia, chosen), thrown(wrong, chosen)};
  Sketch sketch(760, 640, "A racket in the box along the axes, and two throws", 17);
  draw_box(sketch, R, box, difference);
  const auto lies = [&](const FreeTrajectory& motion) { return to_matrix(motion.at(now[time]).q); };
  draw_throw(sketch, lies(both.own), chosen, 440, "c0", "its own inertia");
  draw_throw(sketch, lies(both.with_box), chosen, 645, "c6", "that of the box");
  draw_apart(sketch, both, now[time], difference);
  return sketch.svg();
}

void drag(std::span<double> settings, const Drag& pointer) {
  double turned = settings[around] + pointer.dx;
  if (turned > 180) turned -= 360;
  if (turned < -180) turned += 360;
  settings[around] = allowed(controls[around], turned);
  settings[up] = allowed(controls[up], settings[up] - pointer.dy);
}

}  // namespace
}  // namespace bounding_boxes_chapter::throws_figure

const tumble::support::MovingFigure tumble::figures::throws{
    "throws", bounding_boxes_chapter::throws_figure::controls,
    bounding_boxes_chapter::throws_figure::draw, bounding_boxes_chapter::throws_figure::drag,
    bounding_boxes_chapter::throws_figure::time};
