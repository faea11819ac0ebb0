/// @file
/// Figure 5.7: where ω goes while L stands still; and what a reader can move in it: the box, the
/// direction of ω, and what the solver stores.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "05_momentum/free_flight.hpp"
#include "05_momentum/moving_figures.hpp"
#include "objects/shapes.hpp"
#include "support/space_sketch.hpp"
#include "support/view.hpp"
#include "tumble/mass/solids/box.hpp"

namespace momentum_chapter::wander_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::Vec2;

constexpr double degree = std::numbers::pi / 180;
constexpr double film = 12, spacing = 0.05;  // of what is shown [s]
constexpr int steps = 120;                   // of the solver
constexpr double long_edge = 1, speed = 4;   // [m], of the start [rad/s]

enum Which { middle, small, aim, stored, time };
constexpr std::array<Control, 5> controls{
    {{"b", "second edge, the first has 1 m", "m", 0.1, 1, 0.05, 0.6},
     {"c", "third edge", "m", 0.1, 1, 0.05, 0.2},
     {"aim", "ω from the first edge towards the third", "°", 0, 90, 1, 48},
     {"stored", "the solver stores", "", 0, 3, 1, 0,
      "L|ω in world axes|ω in body axes|ω, and forgets ω × L"},
     {"t", "time", "s", 0, film, spacing, 7}}};

struct Motion {
  Vec3 edges;
  double bound;  ///< of the angle between L and ω [rad]
  std::vector<Sample> samples;
};

Motion moved(Settings now) {
  const Vec3 edges(long_edge, now[middle], now[small]);
  const RigidBody<> body(mass_properties(Box{edges}, 1));
  const Vec3 moments = body.I_body().diagonal();
  const double A = moments.minCoeff(), C = moments.maxCoeff(), angle = now[aim] * degree;
  return {edges, std::asin((C - A) / (C + A)),
          flown(body, storages<double>[static_cast<std::size_t>(now[stored])],
                speed * Vec3(std::cos(angle), 0, std::sin(angle)), film, steps)};
}

/// The motion by the settings; it is computed again when they change.
const Motion& motion_of(Settings now) {
  static Motion motion;
  static std::vector<double> last;
  const std::vector<double> wanted(now.begin(), now.begin() + time);
  if (wanted != last) motion = moved(now);
  last = wanted;
  return motion;
}

// ── In space ──

/// The plane in which the tip of ω stays, if the motion is right: a pale disc.
void draw_invariable_plane(support::Sketch& sketch, const support::SpaceSketch& space,
                           double height) {
  std::vector<Vec2> rim;
  for (const Vec3& p : support::arc({0, 0, height}, {0.8, 0, 0}, Vec3::UnitZ(), 360 * degree))
    rim.push_back(space.seen(p));
  sketch.curve(rim, {"faint", 1.2, 1, 0.12});
}

void draw_in_space(support::Sketch& sketch, const Motion& motion, std::size_t now) {
  constexpr double x = 205, y = 355, scale = 205;
  const Mat3 view = support::view_from(-70 * degree, 24 * degree);
  const std::vector<Sample>& samples = motion.samples;
  double most = 0;  // of ω: the longest arrow fits into the picture
  for (const Sample& each : samples) most = std::max(most, each.omega.norm());
  const double L = samples[0].L.norm(), height = samples[0].omega.z() / most;
  sketch.drawing(support::draw_mesh(shapes::box(-motion.edges / 2, motion.edges / 2),
                                    view * to_matrix(samples[now].q), {x, y, 0.85 * scale}));
  sketch.look({x, y, scale});
  support::SpaceSketch space(sketch, view);
  draw_invariable_plane(sketch, space, height);
  std::vector<Vec3> path;
  for (const Sample& each : samples) path.emplace_back(each.omega / most);
  space.curve(path, {"c1", 1.2, 0.35});
  path.resize(now + 1);
  space.curve(path, {"c1", 1.8});
  const Vec3 tip = 1.35 * samples[now].L / L;
  space.arrow(Vec3::Zero(), tip, {"c0", 3});
  space.words(tip, {12, 6}, "L", "c0", "start");
  space.arrow(Vec3::Zero(), path.back(), {"c1", 2.6});
  space.words(0.6 * path.back(), {10, 6}, "ω", "c1", "start");  // clear of the way of its tip
  sketch.grip({{0, 0}, space.seen(path.back())}, 40);
  sketch.look({50, 520, 1});
  support::SpaceSketch(sketch, view).world_axes(Vec3::Zero(), 40);
}

// ── Over time ──

/// A strip with one number over time, between `least` and `most`.
struct Strip {
  double bottom, least, most;
  std::string low_name, high_name;  ///< of least and most
  std::string words, colour;
  double (*of)(const Sample& now, const Sample& start);
};

constexpr double left = 490, width = 250, height = 95;

double lost_L(const Sample& now, const Sample& start) {
  return (now.L - start.L).norm() / start.L.norm();
}

double lost_energy(const Sample& now, const Sample& start) {
  return now.energy() / start.energy() - 1;
}

double apart(const Sample& now, const Sample&) {
  return std::atan2(now.L.cross(now.omega).norm(), now.L.dot(now.omega));
}

void draw_scale(support::Sketch& sketch, const Strip& strip, const Vec2& low, const Vec2& high) {
  sketch.words(low, {-7, 4}, strip.low_name, "faint", "end");
  sketch.words({low.x(), high.y()}, {-7, 8}, strip.high_name, "faint", "end");
  sketch.frame(low, high, {"grid", 1});
}

void draw_strip(support::Sketch& sketch, const Strip& strip, const std::vector<Sample>& samples,
                std::size_t now) {
  const auto at = [&](double i, double value) -> Vec2 {
    const double part =
        (std::clamp(value, strip.least, strip.most) - strip.least) / (strip.most - strip.least);
    return {left + width * i * spacing / film, part * height - strip.bottom};
  };
  sketch.look({0, 0, 1});
  draw_scale(sketch, strip, at(0, strip.least), at(film / spacing, strip.most));
  if (strip.least < 0) sketch.curve({at(0, 0), at(film / spacing, 0)}, {"faint", 1});
  std::vector<Vec2> curve;
  for (std::size_t i = 0; i < samples.size(); ++i)
    curve.push_back(at(static_cast<double>(i), strip.of(samples[i], samples[0])));
  sketch.curve(curve, {strip.colour, 2});
  sketch.dot(curve[now], strip.colour, 5);
  const double value = strip.of(samples[now], samples[0]);
  const bool shown = strip.least <= value && value <= strip.most;
  sketch.words(at(0, strip.most), {0, -9}, strip.words, strip.colour);
  if (!shown) sketch.words(at(film / spacing, strip.most), {-6, 18}, "off scale", "faint", "end");
}

std::string percent(double part) {
  constexpr double most = 9.99;
  if (std::abs(part) > most) return "> 999 %";
  const std::string number = support::svg_number(100 * std::abs(part), 1);
  return (part < 0 && number != "0" ? "−" : "") + number + " %";
}

void draw_over_time(support::Sketch& sketch, const Motion& motion, std::size_t i) {
  const std::vector<Sample>& samples = motion.samples;
  const Sample &now = samples[i], &start = samples[0];
  const auto angle = [](double radians) { return support::svg_number(radians / degree, 1) + "°"; };
  const double most = 80 * degree;
  draw_strip(sketch,
             {140, 0, 1, "0", "100 %", "|L − L₀| is " + percent(lost_L(now, start)) + " of L₀",
              "c0", lost_L},
             samples, i);
  draw_strip(sketch,
             {300, -0.5, 0.5, "−50 %", "50 %",
              "energy is off by " + percent(lost_energy(now, start)), "c2", lost_energy},
             samples, i);
  draw_strip(
      sketch,
      {460, 0, most, "0", "80°", "L and ω are " + angle(apart(now, start)) + " apart", "c1", apart},
      samples, i);
  const double bound = -460 + height * motion.bound / most;
  sketch.curve({{left, bound}, {left + width, bound}}, {"ink", 1.2, 0.7});
  sketch.words({left + width, bound}, {-6, -6}, "bound " + angle(motion.bound), "ink", "end");
  sketch.words({left, -460}, {0, 22}, "0 s", "faint", "middle");
  sketch.words({left + width, -460}, {0, 22}, "12 s", "faint", "end");
}

std::string draw(Settings now) {
  const Motion& motion = motion_of(now);
  const auto i = static_cast<std::size_t>(std::lround(now[time] / spacing));
  support::Sketch sketch(760, 535, "A box in free flight: the path of ω while L stands still", 17);
  draw_in_space(sketch, motion, i);
  draw_over_time(sketch, motion, i);
  return sketch.svg();
}

/// Aims ω at the start, so it shows the start.
void drag(std::span<double> settings, const Drag& pointer) {
  settings[time] = 0;
  constexpr double per_pixel = 0.5;  // [°]
  settings[aim] = allowed(controls[aim], settings[aim] + per_pixel * (pointer.dx - pointer.dy));
}

}  // namespace
}  // namespace momentum_chapter::wander_figure

const tumble::support::MovingFigure tumble::figures::wander{
    "wander", momentum_chapter::wander_figure::controls, momentum_chapter::wander_figure::draw,
    momentum_chapter::wander_figure::drag, momentum_chapter::wander_figure::time};
