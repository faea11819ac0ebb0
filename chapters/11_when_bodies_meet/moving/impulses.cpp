/// @file
/// Figure 11.7: a rod meets the floor, and the plane of all impulses that its tip could get. A
/// reader moves the rod, its slip, and both coefficients.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "11_when_bodies_meet/impulse_sketch.hpp"
#include "11_when_bodies_meet/moving_figures.hpp"
#include "11_when_bodies_meet/rod_sketch.hpp"

namespace contact_chapter::impulses_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::Sketch;
using support::svg_number;

enum Which { angle, slip, restitution, friction };
constexpr std::array<Control, 4> controls{{{"angle", "angle of the rod", "°", 10, 90, 1, 30},
                                           {"slip", "slip before", "m/s", -1, 1, 0.05, 0.2},
                                           {"e", "restitution e", "", 0, 1, 0.05, 0.9},
                                           {"mu", "friction μ", "", 0, 1.5, 0.05, 0.5}}};

PlanarImpact impact_of(Settings now) {
  return {tip_of_rod(now[angle] * degree), {now[slip], -1}, now[restitution], now[friction]};
}

// ── The rod, and the velocities of its tip ──

/// Where the tip is drawn, and how long a metre and a metre per second are [px].
const support::Window world{185, 262, 95};

/// @param left whether its name is to its left
void draw_velocity(Sketch& sketch, const Vec2& u, const std::string& colour,
                   const std::string& name, bool left) {
  constexpr double farthest = 1.1;  // to the left, or the name would not be seen [m/s]
  if (u.norm() > 1e-3) sketch.arrow({0, 0}, u, {colour, 2.8});
  const Vec2 tip(left ? std::max(u.x(), -farthest) : u.x(), u.y());
  sketch.words(tip, {left ? -8. : 8., u.y() < -0.01 ? 14. : -6.}, name, colour,
               left ? "end" : "start");
}

void draw_world(Sketch& sketch, const PlanarImpact& impact, const Answers& answers, double tilt) {
  sketch.look(world);
  draw_floor(sketch, -1.8, 2.1);
  draw_rod(sketch, tilt);
  draw_velocity(sketch, impact.u, "ink", "before", impact.u.x() < 0);
  sketch.words({0, 0}, {-150, -215}, "drag the rod, or the arrow below the floor", "faint");
  const Vec2 &usual = answers.usual.u, &ours = answers.ours.u;
  // Where both stick, only rounding would tell which one is to the left.
  const bool alike = (usual - ours).norm() < 0.01, left = usual.x() < ours.x() - 1e-9;
  draw_velocity(sketch, usual, answers.usual_colour(), alike ? "" : "tutorials", left);
  draw_velocity(sketch, ours, "c2", alike ? "both" : "slip followed", !left);
  sketch.grip({{0, 0}, 2 * Vec2(std::cos(tilt), std::sin(tilt))}, 20);
  sketch.grip({{0, 0}, impact.u}, 20);
}

// ── Energy ──

/// What becomes of the slip, in words.
std::string fate_of_slip(const PlanarImpact& impact, const PlanarResult& ours) {
  if (ContactPath(impact).rest() >= ours.impulse.y()) return "the slip doesn't end";
  return std::abs(ours.u.x()) < 1e-9 ? "the tip sticks" : "the slip turns round";
}

void draw_energy(Sketch& sketch, const PlanarImpact& impact, const Answers& answers) {
  constexpr double left = 150, top = 455, unit = 270, line = 28;
  sketch.look({0, 0, 1});
  const auto bar = [&](int i, const std::string& name, double share, const std::string& colour) {
    const double y = -top - i * line, end = left + unit * share;
    sketch.curve({{left, y - 7}, {end, y - 7}, {end, y + 7}, {left, y + 7}, {left, y - 7}},
                 {colour, 1, 1, 0.6});
    sketch.words({left, y}, {-10, 6}, name, colour, "end");
    const bool meets_line = share > 0.7 && share < 1;
    sketch.words({meets_line ? left + unit : end, y}, {8, 6}, svg_number(100 * share, 1) + " %",
                 colour);
  };
  bar(0, "before", 1, "ink");
  bar(1, "tutorials", answers.usual_left, answers.usual_colour());
  bar(2, "slip followed", answers.ours_left, "c2");
  if (answers.readers) bar(3, "yours", answers.readers_left, readers_colour);
  const int last = answers.readers ? 3 : 2;
  sketch.curve({{left + unit, -top + 12}, {left + unit, -top - last * line - 12}}, {"ink", 1, 0.6});
  sketch.words({left, -top + 12}, {0, -10}, "energy that is left, of ½ uᵀK⁻¹u");
  sketch.words({plane_right, -top - 2 * line}, {0, 6}, fate_of_slip(impact, answers.ours), "c2",
               "end");
}

// ── By the reader's collide_with_friction (11.6) ──

/// The impulse of the reader's function, or nothing.
std::optional<Vec2>& readers_impulse() {
  static std::optional<Vec2> impulse;
  return impulse;
}

std::vector<double> question(Settings now) {
  const PlanarImpact impact = impact_of(now);
  const Mat2& K = impact.K;
  return {K(0, 0), K(0, 1), K(1, 0), K(1, 1), impact.u.x(), impact.u.y(), impact.e, impact.mu};
}

void take(Settings, std::span<const double> answer) {
  readers_impulse().reset();
  if (answer.size() == 2) readers_impulse() = Vec2(answer[0], answer[1]);
}

constexpr support::ReadersAnswer by_reader{"impact", question, take};

std::string draw(Settings now) {
  const PlanarImpact impact = impact_of(now);
  const Answers answers = answers_of(impact, readers_impulse());
  Sketch sketch(760, answers.readers ? 568 : 540,
                "A rod meets the floor, and the impulses that its tip could get");
  draw_world(sketch, impact, answers, now[angle] * degree);
  draw_plane(sketch, impact, answers);
  draw_energy(sketch, impact, answers);
  return sketch.svg();
}

/// Above the floor the reader has hold of the rod, below it of the arrow with which its tip comes.
void drag(std::span<double> settings, const Drag& pointer) {
  static bool of_arrow;
  const double up = world.y - pointer.y, right = pointer.x - world.x;
  if (pointer.begins()) of_arrow = up < 0;
  if (of_arrow)
    settings[slip] = allowed(controls[slip], right / world.scale);
  else
    settings[angle] = allowed(controls[angle], std::atan2(std::max(up, 0.), right) / degree);
}

}  // namespace
}  // namespace contact_chapter::impulses_figure

const tumble::support::MovingFigure tumble::figures::impulses{
    "impulses",
    contact_chapter::impulses_figure::controls,
    contact_chapter::impulses_figure::draw,
    contact_chapter::impulses_figure::drag,
    -1,
    &contact_chapter::impulses_figure::by_reader};
