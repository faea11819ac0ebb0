/// @file
/// Figure 11.7: a rod meets the floor, and the plane of all impulses that its tip could get. A
/// reader moves the rod, its slip, and both coefficients.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "11_when_bodies_meet/impulse_plane.hpp"
#include "11_when_bodies_meet/laws.hpp"
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
constexpr std::array<Control, 4> controls{{{"angle", "rod to the floor", "°", 10, 90, 1, 30},
                                           {"slip", "slip before", "m/s", -1, 1, 0.05, 0.2},
                                           {"e", "restitution e", "", 0, 1, 0.05, 0.9},
                                           {"mu", "friction μ", "", 0, 1.5, 0.05, 0.5}}};

PlanarImpact impact_of(Settings now) {
  return {tip_of_rod(now[angle] * degree), {now[slip], -1}, now[restitution], now[friction]};
}

/// What two laws make of an impact.
struct Answers {
  PlanarResult usual, ours;
  double usual_left, ours_left;  ///< of ½ uᵀK⁻¹u

  /// Where the usual law has more energy than there was, it is drawn in red.
  std::string usual_colour() const { return usual_left > 1 + 1e-9 ? "c6" : "c1"; }
};

Answers answers_of(const PlanarImpact& impact) {
  const PlanarResult usual = usual_law(impact), ours = stronge_law(impact);
  const double stake = energy_at_stake(impact);
  return {usual, ours, 1 + energy_change(impact, usual) / stake,
          1 + energy_change(impact, ours) / stake};
}

// ── The rod, and the velocities of its tip ──

/// Where the tip is drawn, and how long a metre and a metre per second are [px].
const support::Window world{185, 262, 95};

/// @param left whether its name stands to its left
void draw_velocity(Sketch& sketch, const Vec2& u, const std::string& colour,
                   const std::string& name, bool left) {
  constexpr double farthest = 1.1;  // to the left, or the name would not be seen [m/s]
  if (u.norm() > 1e-3) sketch.arrow({0, 0}, u, {colour, 2.8});
  const Vec2 tip(left ? std::max(u.x(), -farthest) : u.x(), u.y());
  sketch.words(tip, {left ? -8. : 8., u.y() < 0 ? 14. : -6.}, name, colour, left ? "end" : "start");
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
}

// ── The plane of impulses ──

constexpr double plane_left = 420, plane_right = 745, plane_top = 40, plane_bottom = 395;

/// All of the curve and both ends, as large as there is room.
support::Window window_of(const std::vector<Vec2>& curve, const Answers& answers) {
  Extent all{curve[0], curve[0]};
  for (const Vec2& point : curve) all.hold(point);
  for (const Vec2& point : {Vec2(0, 0), answers.usual.impulse, answers.ours.impulse})
    all.hold(point);
  const Vec2 room(plane_right - plane_left - 40, plane_bottom - plane_top - 40);
  const double scale = room.cwiseQuotient(all.size()).minCoeff();
  const Vec2 middle = scale * all.middle();
  return {(plane_left + plane_right) / 2 - middle.x(), (plane_top + plane_bottom) / 2 + middle.y(),
          scale};
}

/// The part of the plane that is seen.
Extent seen(const support::Window& window) {
  return {{(plane_left - window.x) / window.scale, (window.y - plane_bottom) / window.scale},
          {(plane_right - window.x) / window.scale, (window.y - plane_top) / window.scale}};
}

/// Where nothing slips, and where the bodies come together no more.
void draw_lines(Sketch& sketch, const PlanarImpact& impact, const Extent& seen) {
  const std::vector<Vec2> sticking = line_within(impact.K.row(0), impact.u.x(), seen),
                          closest = line_within(impact.K.row(1), impact.u.y(), seen);
  if (!sticking.empty()) {
    sketch.curve(sticking, {"c0", 1.6});
    const Vec2& top = sticking[0].y() > sticking[1].y() ? sticking[0] : sticking[1];
    sketch.words(top, {22, -8}, "sticking", "c0", "end");
  }
  if (!closest.empty()) {
    sketch.curve(closest, {"c3", 1.6});
    const Vec2& right = closest[0].x() > closest[1].x() ? closest[0] : closest[1];
    sketch.words(right, {-4, -8}, "compressed", "c3", "end");
  }
}

/// Friction can't be more than μ times the normal impulse.
void draw_cone(Sketch& sketch, double mu, const Extent& seen) {
  const double high = seen.high.y(), right = std::min(mu * high, seen.high.x()),
               left = std::max(-mu * high, seen.low.x());
  std::vector<Vec2> cone{{0, 0}};
  if (mu * high > seen.high.x()) cone.emplace_back(right, right / mu);
  cone.insert(cone.end(), {{right, high}, {left, high}});
  if (-mu * high < seen.low.x()) cone.emplace_back(left, -left / mu);
  cone.emplace_back(0, 0);
  sketch.curve(cone, {"c4", 1.2, 1, 0.1});
  if (mu > 0) sketch.words({(left + right) / 2, high}, {0, 20}, "cone", "c4", "middle");
}

/// The library's impulse while it grows, with a dot where the slip ends.
void draw_path(Sketch& sketch, const PlanarImpact& impact, const PlanarResult& ours) {
  const ContactPath path(impact);
  const double end = ours.impulse.y();
  std::vector<Vec2> points{{0, 0}};
  if (path.rest() < end) points.push_back(path.impulse(path.rest()));
  points.push_back(ours.impulse);
  sketch.curve(points, {"c2", 3});
  if (points.size() == 3) sketch.dot(points[1], "ink", 4);
  sketch.dot(ours.impulse, "c2", 6);
}

void draw_plane(Sketch& sketch, const PlanarImpact& impact, const Answers& answers) {
  const std::vector<Vec2> curve = lossless(impact);
  const support::Window window = window_of(curve, answers);
  const Extent extent = seen(window);
  sketch.look(window);
  sketch.frame(extent.low, extent.high, {"grid", 1});
  sketch.curves(
      {{{extent.low.x(), 0}, {extent.high.x(), 0}}, {{0, extent.low.y()}, {0, extent.high.y()}}},
      {"faint", 1});
  draw_cone(sketch, impact.mu, extent);
  sketch.curve(curve, {"ink", 1.6, 0.8});
  draw_lines(sketch, impact, extent);
  sketch.curve({{0, 0}, answers.usual.impulse}, {answers.usual_colour(), 2, 0.8});
  draw_path(sketch, impact, answers.ours);
  sketch.dot(answers.usual.impulse, answers.usual_colour(), 6);
  sketch.look({0, 0, 1});
  sketch.words({plane_left, -plane_top}, {0, -8}, "↑ normal", "faint");
  sketch.words({plane_right, -plane_bottom}, {0, 22}, "impulse along the floor →", "faint", "end");
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
  sketch.curve({{left + unit, -top + 12}, {left + unit, -top - 2 * line - 12}}, {"ink", 1, 0.6});
  sketch.words({left, -top + 12}, {0, -10}, "energy that is left, of ½ uᵀK⁻¹u");
  sketch.words({plane_right, -top - 2 * line}, {0, 6}, fate_of_slip(impact, answers.ours), "c2",
               "end");
}

std::string draw(Settings now) {
  Sketch sketch(760, 540, "A rod meets the floor, and the impulses that its tip could get");
  const PlanarImpact impact = impact_of(now);
  const Answers answers = answers_of(impact);
  draw_world(sketch, impact, answers, now[angle] * degree);
  draw_plane(sketch, impact, answers);
  draw_energy(sketch, impact, answers);
  return sketch.svg();
}

/// Above the floor the rod follows the pointer, below it the arrow with which its tip comes.
void drag(std::span<double> settings, const Drag& pointer) {
  if (pointer.x > plane_left) return;
  const double up = world.y - pointer.y, right = pointer.x - world.x;
  if (up < 0)
    settings[slip] = allowed(controls[slip], right / world.scale);
  else
    settings[angle] = allowed(controls[angle], std::atan2(up, right) / degree);
}

}  // namespace
}  // namespace contact_chapter::impulses_figure

const tumble::support::MovingFigure tumble::figures::impulses{
    "impulses", contact_chapter::impulses_figure::controls, contact_chapter::impulses_figure::draw,
    contact_chapter::impulses_figure::drag};
