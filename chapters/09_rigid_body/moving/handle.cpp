/// @file
/// A T-handle that turns over: in the world, on the sphere of L, and its spins over time.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "09_rigid_body/handle_motion.hpp"
#include "09_rigid_body/moving_figures.hpp"
#include "09_rigid_body/polhodes.hpp"
#include "support/scene_for_reader.hpp"
#include "support/space_sketch.hpp"
#include "support/view.hpp"

namespace rigid_body_chapter::handle_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;

constexpr double degree = pi / 180;

enum Which { time, aim, law, around, above };
constexpr std::array<Control, 5> controls{
    {{"t", "time", "s", 0, longest, spacing, 1.2},
     {"aim", "aim is off by 10⁻ᵏ rad, k =", "", 0.5, 6, 0.1, 2},
     {"law", "law of motion", "", 0, 2, 1, 0,
      "the right one|gyroscopic term left out|gyroscopic term put in twice"},
     {"around", "you stand at", "°", -180, 180, 1, 30},
     {"above", "and look down by", "°", -80, 80, 1, 20}}};
/// The laws of the control, among all.
constexpr std::array<std::size_t, 3> offered{0, 2, 3};

/// What a reader's functions gave, or nothing.
std::vector<Sample>& readers_motion() {
  static std::vector<Sample> all;
  return all;
}

/// The motion by the settings; it is computed again when they change.
const std::vector<Sample>& motion_of(Settings now) {
  if (!readers_motion().empty()) return readers_motion();
  static std::vector<Sample> all;
  static double last_aim = -1, last_law = -1;
  if (now[aim] == last_aim && now[law] == last_law) return all;
  last_aim = now[aim];
  last_law = now[law];
  const RigidBodyState<> start = start_of(std::pow(10., -now[aim]));
  const Law& chosen = laws[offered[static_cast<std::size_t>(now[law])]];
  all = chosen.rate == L_stays ? in_closed_form(start) : by_steps(chosen, start);
  return all;
}

void draw_in_the_world(support::Sketch& sketch, const Sample& now, const Sample& start,
                       const Mat3& view) {
  constexpr double x = 190, y = 190, scale = 1750;
  sketch.drawing(support::draw_mesh(the_handle().mesh, view * to_matrix(now.q), {x, y, scale}));
  sketch.look({x, y, 150});
  sketch.grip({{0, 0}}, 130);
  support::SpaceSketch space(sketch, view);
  const Vec3 L = now.L.normalized(), L_at_start = start.L.normalized();
  space.arrow(Vec3::Zero(), L_at_start, {"faint", 1.2});
  space.arrow(Vec3::Zero(), L, {"ink", 2});
  space.words(L, {0, -8}, "L");
  if ((L - L_at_start).norm() < 0.1) return;
  const bool left = space.seen(L).x() > space.seen(L_at_start).x();
  space.words(L_at_start, {left ? -8. : 8., 4}, "at the start", "faint", left ? "end" : "start");
}

/// The tip of L in the body, as a part of its length at the start.
Vec3 tip_of(const Sample& now, const Sample& start) {
  return now.omega.cwiseProduct(the_handle().axes.moments) / start.L.norm();
}

void draw_on_the_sphere(support::Sketch& sketch, const std::vector<Sample>& all, std::size_t i) {
  constexpr std::size_t trail = 150;
  sketch.look({570, 190, 172});
  draw_sphere(sketch, the_handle().axes.moments, "red: L in the body; the three dots: its axes");
  Way way{{}, {"ink", 2.6}};
  for (std::size_t k = i < trail ? 0 : i - trail; k <= i; ++k)
    way.points.push_back(tip_of(all[k], all[0]));
  for (const bool near : {false, true})
    sketch.curves(visible(way, sphere_view(), near), {"ink", near ? 2.6 : 1.4, near ? 1 : 0.4});
  const Vec3 tip = sphere_view() * way.points.back();
  sketch.dot(tip.head<2>(), "c6", tip.z() > 0 ? 6 : 3);  // smaller where it is behind the sphere
}

void draw_spins(support::Sketch& sketch, const std::vector<Sample>& all, std::size_t i) {
  constexpr double left = 40, middle = 510, width = 630, height = 62;
  const auto at = [&](std::size_t k, double omega) -> Vec2 {
    return {static_cast<double>(k) * width / samples, omega / (2 * pi) * height};
  };
  sketch.look({left, middle, 1});
  sketch.curve({at(0, 0), at(samples, 0)}, {"faint", 1});
  for (const int turns : {-1, 0, 1})
    sketch.words(at(0, 2 * pi * turns), {-9, 6},
                 (turns < 0 ? "−" : "") + std::to_string(std::abs(turns)), "faint", "end");
  sketch.words(at(samples, -8), {0, 18}, "20 s", "faint", "end");
  const std::array<std::string, 3> names{"least", "middle", "largest"}, colours{"c0", "c1", "c2"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Vec2> curve;
    for (std::size_t k = 0; k <= samples; k += 2)
      curve.push_back(at(k, all[k].omega[static_cast<Eigen::Index>(axis)]));
    sketch.curve(curve, {colours[axis], 1.6});
    sketch.words({width, 0}, {10, 6 + 24 * (static_cast<double>(axis) - 1)}, names[axis],
                 colours[axis]);
  }
  sketch.curve({at(i, -8), at(i, 8)}, {"ink", 1.2});
  sketch.words({0, -96}, {0, 0}, "turns per second about the axes of its three moments of inertia");
}

std::string draw(Settings now) {
  const std::vector<Sample>& all = motion_of(now);
  const auto i = static_cast<std::size_t>(std::lround(now[time] / spacing));
  support::Sketch sketch(760, 620, "A T-handle that turns over, and the tip of L in it", 17);
  draw_in_the_world(sketch, all[i], all[0],
                    support::view_from(now[around] * degree, now[above] * degree));
  draw_on_the_sphere(sketch, all, i);
  draw_spins(sketch, all, i);
  return sketch.svg();
}

void drag(std::span<double> settings, const Drag& pointer) {
  constexpr double per_pixel = 0.5;
  double turned = settings[around] - per_pixel * pointer.dx;
  if (turned > 180) turned -= 360;
  if (turned < -180) turned += 360;
  settings[around] = allowed(controls[around], turned);
  settings[above] = allowed(controls[above], settings[above] + per_pixel * pointer.dy);
}

// ── By the reader's functions ──

std::vector<double> question(Settings now) {
  constexpr int steps_a_sample = 4;
  std::vector<double> all =
      support::scene_for_reader(the_handle().body, start_of(std::pow(10., -now[aim])), longest);
  all.insert(all.end(), {steps_a_sample * samples, samples});
  return all;
}

void take(Settings, std::span<const double> states) {
  readers_motion().clear();
  for (const RigidBodyState<>& state : support::states_from_reader(states))
    readers_motion().push_back(sample(state.q, state.L));
}

constexpr support::ReadersAnswer by_reader{"motion", question, take};

}  // namespace
}  // namespace rigid_body_chapter::handle_figure

const tumble::support::MovingFigure tumble::figures::handle{
    "handle",
    rigid_body_chapter::handle_figure::controls,
    rigid_body_chapter::handle_figure::draw,
    rigid_body_chapter::handle_figure::drag,
    rigid_body_chapter::handle_figure::time,
    &rigid_body_chapter::handle_figure::by_reader};
