/// @file
/// Figure 11.9: a die that is thrown onto a table, and where its energy goes. A reader drags the
/// throw, and time goes on.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "11_when_bodies_meet/die_sketch.hpp"
#include "11_when_bodies_meet/moving_figures.hpp"
#include "11_when_bodies_meet/planar_impact.hpp"
#include "11_when_bodies_meet/thrown_die.hpp"
#include "support/space_sketch.hpp"

namespace contact_chapter::strip_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::Sketch;
using support::svg_number;

constexpr double longest = 1, slower = 10;  // of what is shown [s], than it is
constexpr double edge = die_edge, mu = 0.4;

enum Which { along, up, spin, restitution, time };
constexpr std::array<Control, 5> controls{
    {{"along", "thrown forwards", "m/s", 0, 0.8, 0.05, 0.5},
     {"up", "and upwards", "m/s", -0.6, 0.6, 0.05, 0.4},
     {"spin", "spin forwards", "turns/s", -15, 15, 0.5, 3},
     {"e", "restitution e", "", 0.1, 0.7, 0.05, 0.6},
     {"t", "film, slowed 10×", "s", 0, slower* longest, 0.05, 6}}};

// ── The throw ──

contact::ContactScene scene_of(Settings now) {
  const RigidBody<> body = the_die();
  const Vec3 omega(10, 2 * pi * now[spin], 4);
  const RigidBodyState<> start{{0, 0, 0.09},
                               Quat(0.9, 0.3, 0.2, 0.25).normalized(),
                               body.mass() * Vec3(now[along], 0, now[up]),
                               body.I_body() * omega};
  return {{{"die", body, collide::Convex::box(Vec3::Constant(edge)), start}},
          {collide::HalfSpace{Vec3::Zero(), Vec3::UnitZ()}},
          Vec3(0, 0, -die_gravity),
          now[restitution],
          mu};
}

/// The throw by the settings; it is computed again when they change.
const Throw& throw_of(Settings now) {
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

// ── Where it is drawn ──

/// Where the origin is drawn, and how large the world [px], [px/m].
const support::Window sheet{150, 315, 1900};
Mat3 view() { return support::view_from(-76 * degree, 14 * degree); }

// ── The throw, drawn ──

constexpr double drawn_second = 0.08;  // [m] of an arrow for 1 m/s

void draw_throw(Sketch& sketch, const Throw& thrown, Settings now, double t) {
  sketch.look(sheet);
  support::SpaceSketch space(sketch, view());
  for (const double y : {-0.025, -0.01, 0.005, 0.02})
    space.curve({{-0.07, y, 0}, {0.31, y, 0}}, {"faint", 1});
  constexpr double between = 0.04, fine = 0.002;  // [s]
  const double end = std::min(t, thrown.end());
  std::vector<Vec3> path;
  for (int i = 0; i * fine < end; ++i) path.push_back(thrown.at(i * fine).x);
  path.push_back(thrown.at(end).x);
  sketch.drawing("<g opacity=\"0.5\">\n");
  for (int i = 0; i * between < end - between / 2; ++i)
    draw_die(sketch, sheet, view(), thrown.at(i * between));
  sketch.drawing("</g>\n");
  space.curve(path, {"c1", 1.6});
  draw_die(sketch, sheet, view(), thrown.at(t));
  const Vec3 hand = path.front(), aim = hand + drawn_second * Vec3(now[along], 0, now[up]);
  sketch.grip({space.seen(aim)});
  if ((aim - hand).norm() < 1e-6) return;
  space.arrow(hand, aim, {"c6", 2.4});
  space.words(aim, {12, 6}, "v", "c6");
}

// ── Its energy ──

/// What the die has at a time, each above the one before [mJ].
struct Energies {
  double t, turning, moving, all;
};

Energies energies_at(const Throw& thrown, const SteadyFlight& flight, double t) {
  constexpr double milli = 1e3;
  const RigidBodyState<> state = flight.state(t);
  const double mass = thrown.body.mass(),
               turning = state.L.squaredNorm() / thrown.body.I_body()(0, 0) / 2,
               moving = state.P.squaredNorm() / mass / 2,
               height = mass * die_gravity * (state.x.z() - edge / 2);
  return {t, milli * turning, milli * (turning + moving), milli * (turning + moving + height)};
}

std::vector<Energies> energies_of(const Throw& thrown) {
  constexpr double fine = 0.008;  // [s]
  std::vector<Energies> all;
  const auto& legs = thrown.legs();
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double begin = legs[i].t, end = i + 1 < legs.size() ? legs[i + 1].t : thrown.run.t;
    const int parts = 1 + static_cast<int>((end - begin) / fine);
    for (int k = 0; k <= parts && legs[i].on_wall < 0; ++k)
      all.push_back(energies_at(thrown, thrown.flight(legs[i]), begin + k * (end - begin) / parts));
  }
  return all;
}

constexpr double strip_left = 60, strip_bottom = 575, per_second = 640, per_millijoule = 21;

/// What lies between two of the curves.
void draw_band(Sketch& sketch, const std::vector<Energies>& all, double Energies::*low,
               double Energies::*high, const std::string& colour) {
  std::vector<Vec2> band;
  for (const Energies& each : all)
    band.emplace_back(per_second * each.t, per_millijoule * each.*high);
  for (auto each = all.rbegin(); each != all.rend(); ++each)
    band.emplace_back(per_second * each->t, low ? per_millijoule * (*each).*low : 0);
  sketch.curve(band, {colour, 0.6, 1, 0.45});
}

void draw_energy(Sketch& sketch, const Throw& thrown, double t) {
  const std::vector<Energies> all = energies_of(thrown);
  sketch.look({strip_left, strip_bottom, 1});
  draw_band(sketch, all, &Energies::moving, &Energies::all, "c2");
  draw_band(sketch, all, &Energies::turning, &Energies::moving, "c0");
  draw_band(sketch, all, nullptr, &Energies::turning, "c1");
  sketch.curve({{0, 0}, {per_second * longest, 0}}, {"faint", 1});
  std::vector<std::vector<Vec2>> marks;
  for (const contact::ImpactEvent& impact : thrown.run.impacts)
    marks.push_back({{per_second * impact.t, -9}, {per_second * impact.t, 0}});
  sketch.curves(marks, {"c6", 1.2});
  sketch.curve({{per_second * t, -12}, {per_second * t, 150}}, {"ink", 1.2});
  sketch.words({0, per_millijoule * all[0].all}, {-6, 6}, svg_number(all[0].all, 1) + " mJ", "ink",
               "end");
  const double right = per_second * longest;
  sketch.words({right, 140}, {0, 0}, "energy: height", "c2", "end");
  sketch.words({right, 117}, {0, 0}, "moving", "c0", "end");
  sketch.words({right, 94}, {0, 0}, "turning", "c1", "end");
  sketch.words({right, 60}, {0, 0}, "impacts", "c6", "end");
}

std::string caption_of(const Throw& thrown, double t) {
  if (t < thrown.end() || thrown.run.ending == contact::Ending::time)
    return "after " + svg_number(t, 3) + " s";
  const std::string since = " since " + svg_number(thrown.end(), 2) + " s";
  if (thrown.run.ending == contact::Ending::lasting_contact) return "on an edge" + since;
  return "at rest" + since + ": on top is " + svg_number(number_shown(thrown.at(t)), 0);
}

std::string draw(Settings now) {
  const Throw& thrown = throw_of(now);
  const double t = now[time] / slower;
  Sketch sketch(760, 600, "A thrown die at equal times, and where its energy goes");
  draw_throw(sketch, thrown, now, t);
  draw_energy(sketch, thrown, t);
  sketch.look({0, 0, 1});
  sketch.words({740, -30}, {0, 0}, caption_of(thrown, t), "ink", "end");
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
    "strip", contact_chapter::strip_figure::controls, contact_chapter::strip_figure::draw,
    contact_chapter::strip_figure::drag, contact_chapter::strip_figure::time};
