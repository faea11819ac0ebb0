/// @file
/// Figure 11.9: a die that is thrown onto a table, and where its energy goes. A reader drags the
/// throw, and time goes on.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "11_when_bodies_meet/die_energy.hpp"
#include "11_when_bodies_meet/die_sketch.hpp"
#include "11_when_bodies_meet/moving_figures.hpp"
#include "11_when_bodies_meet/planar_impact.hpp"
#include "11_when_bodies_meet/readers_die.hpp"
#include "support/space_sketch.hpp"

namespace contact_chapter::strip_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::Sketch;
using support::svg_number;

constexpr double longest = 1, slower = 10;  // of what is shown [s]; than it is
constexpr double mu = 0.4;

enum Which { along, up, spin, restitution, time };
constexpr std::array<Control, 5> controls{
    {{"along", "thrown forwards", "m/s", 0, 0.6, 0.05, 0.5},
     {"up", "and upwards", "m/s", -0.5, 0.5, 0.05, 0.4},
     {"spin", "spin forwards", "turns/s", -10, 10, 0.5, 3},
     {"e", "restitution e", "", 0.1, 0.6, 0.05, 0.6},
     {"t", "time, ten times slower", "s", 0, longest, 0.005, 0.6}}};

// ── The throw ──

contact::ContactScene scene_of(Settings now) {
  const Vec3 v(now[along], 0, now[up]), omega(10, 2 * pi * now[spin], 4);
  return scene_of_die(objects::die_in_hand(v, omega), now[restitution], mu);
}

/// The throw by the settings; it is computed again when they change.
const Throw& throw_with_friction(Settings now) {
  static Throw thrown;
  static std::array<double, 4> last{-1};
  if (std::equal(last.begin(), last.end(), now.begin())) return thrown;
  std::copy_n(now.begin(), last.size(), last.begin());
  // Hops of a thousandth of the die's reach are too low to see, and there are not so many of them.
  const contact::ContactSettings settings{.until = longest, .hop = 1e-3};
  const contact::ContactScene scene = scene_of(now);
  thrown.run = contact::detail::ContactSimulation<OneBodyEvents>(scene, settings).run();
  return thrown;
}

// ── By the reader's functions ──

std::optional<Throw>& readers_throw() {
  static std::optional<Throw> thrown;
  return thrown;
}

std::vector<double> question(Settings now) { return question_of_die(scene_of(now), longest); }

void take(Settings now, std::span<const double> answer) {
  readers_throw().reset();
  if (!answer.empty()) readers_throw() = readers_die(scene_of(now), longest, answer);
}

constexpr support::ReadersAnswer by_reader{"die", question, take};

// ── Where it is drawn ──

/// Where the origin is drawn, and how large the world [px], [px/m].
const support::Window sheet{232, 230, 1400};
Mat3 view() { return support::view_from(-80 * degree, 38 * degree); }

// ── The throw, drawn ──

constexpr double drawn_second = 0.11;  // [m] of an arrow for 1 m/s

/// The path of its centre until a time.
void draw_path(support::SpaceSketch& space, const Throw& thrown, double end,
               const std::string& colour) {
  constexpr double fine = 0.002;  // [s]
  std::vector<Vec3> path;
  for (int i = 0; i * fine < end; ++i) path.push_back(thrown.at(i * fine).x);
  path.push_back(thrown.at(end).x);
  space.curve(path, {colour, 1.6});
}

void draw_throw(Sketch& sketch, const Throw& thrown, const std::string& colour, double t) {
  constexpr double between = 0.04;  // [s]
  const double end = std::min(t, thrown.end());
  sketch.drawing("<g opacity=\"0.5\">\n");
  for (int i = 0; i * between < end - between / 2; ++i)
    draw_die(sketch, sheet, view(), thrown.at(i * between));
  sketch.drawing("</g>\n");
  support::SpaceSketch space(sketch, view());
  draw_path(space, thrown, end, colour);
  draw_die(sketch, sheet, view(), thrown.at(t));
}

/// As much of the floor as the die can reach, with a line every 2 cm.
void draw_floor(Sketch& sketch) {
  constexpr double left = -0.14, right = 0.36, front = -0.14, back = 0.12, mesh = 0.02;
  support::SpaceSketch space(sketch, view());
  space.curve({{left, front, 0}, {right, front, 0}, {right, back, 0}, {left, back, 0}},
              {"faint", 0, 1, 0.1});
  for (double y = front; y < back + mesh / 2; y += mesh)
    space.curve({{left, y, 0}, {right, y, 0}}, {"faint", 1, 0.35});
  for (double x = left; x < right + mesh / 2; x += mesh)
    space.curve({{x, front, 0}, {x, back, 0}}, {"faint", 1, 0.35});
}

/// Which way it spins: an arrow up its back for forwards, the longer the faster. There v is never.
void draw_spin(support::SpaceSketch& space, const Vec3& hand, double turns) {
  if (turns == 0) return;
  const double angle = (75 + 5 * std::abs(turns)) * degree;
  const Vec3 axis = turns > 0 ? Vec3::UnitY() : Vec3(-Vec3::UnitY());
  const Vec3 back(-1.5 * die_edge, 0, 0);
  const Vec3 start = std::cos(angle / 2) * back - std::sin(angle / 2) * axis.cross(back);
  const std::vector<Vec3> way = support::arc(hand, start, axis, angle);
  space.curve(way, {"c6", 2});
  space.arrow(way[way.size() - 2], way.back(), {"c6", 2});
}

void draw_hand(Sketch& sketch, Settings now) {
  support::SpaceSketch space(sketch, view());
  const Vec3 hand = scene_of(now).body(0).start.x,
             aim = hand + drawn_second * Vec3(now[along], 0, now[up]);
  draw_spin(space, hand, now[spin]);
  sketch.grip({space.seen(aim)});
  if ((aim - hand).norm() < 1e-6) return;
  space.arrow(hand, aim, {"c6", 2.4});
  space.words(aim, {12, 6}, "v", "c6");
}

void draw_all(Sketch& sketch, const Throw& thrown, Settings now, double t) {
  sketch.look(sheet);
  support::SpaceSketch space(sketch, view());
  draw_floor(sketch);
  if (readers_throw()) {
    const Throw& other = throw_with_friction(now);
    draw_path(space, other, std::min(t, other.end()), "c1");
  }
  draw_throw(sketch, thrown, readers_throw() ? "c5" : "c1", t);
  draw_hand(sketch, now);
}

std::string caption_of(const Throw& thrown, double t) {
  if (t < thrown.end() || thrown.run.ending == contact::Ending::time)
    return "after " + svg_number(t, 3) + " s";
  const std::string since = " since " + svg_number(thrown.end(), 2) + " s";
  switch (thrown.run.ending) {
    case contact::Ending::too_many_events:
      return "after " + svg_number(double(thrown.run.impacts.size()), 0) + " impacts, at " +
             svg_number(thrown.end(), 2) + " s, it hops on";
    case contact::Ending::lasting_contact:
      return "on an edge" + since;
    default:
      return "at rest" + since + ": on top is " + svg_number(number_shown(thrown.at(t)), 0);
  }
}

std::string draw(Settings now) {
  const Throw& thrown = readers_throw() ? *readers_throw() : throw_with_friction(now);
  const double t = now[time];
  Sketch sketch(760, 610, "A thrown die at equal times, and where its energy goes");
  draw_all(sketch, thrown, now, t);
  draw_energy(sketch, thrown, longest, t);
  sketch.look({0, 0, 1});
  sketch.words({740, -30}, {0, 0}, caption_of(thrown, t), "ink", "end");
  if (!readers_throw()) return sketch.svg();
  sketch.words({740, -52}, {0, 0}, "yours, without friction", "c5", "end");
  sketch.words({740, -74}, {0, 0}, "the library, with friction", "c1", "end");
  return sketch.svg();
}

void drag(std::span<double> settings, const Drag& pointer) {
  const Mat3 seen = view();
  const Vec2 hand = (seen * Vec3(0, 0, 0.09)).head<2>();
  const Vec2 tip((pointer.x - sheet.x) / sheet.scale, (sheet.y - pointer.y) / sheet.scale);
  const Vec2 shown = (tip - hand) / drawn_second;
  // The arrow is in the plane of x and z; z is not drawn to the side.
  const double right = shown.x() / seen(0, 0);
  settings[along] = allowed(controls[along], right);
  settings[up] = allowed(controls[up], (shown.y() - right * seen(1, 0)) / seen(1, 2));
}

}  // namespace
}  // namespace contact_chapter::strip_figure

const tumble::support::MovingFigure tumble::figures::strip{
    "strip",
    contact_chapter::strip_figure::controls,
    contact_chapter::strip_figure::draw,
    contact_chapter::strip_figure::drag,
    contact_chapter::strip_figure::time,
    &contact_chapter::strip_figure::by_reader,
    1 / contact_chapter::strip_figure::slower};
