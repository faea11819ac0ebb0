/// @file
/// Figure 10.10: error against evaluations of the forces. A reader chooses the scene and asks for
/// an error; the figure says what each method needs for it, and which one the library takes.

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "10_only_what_a_scene_needs/moving_figures.hpp"
#include "10_only_what_a_scene_needs/work_curves.hpp"
#include "support/sketch.hpp"
#include "tumble/body/model.hpp"
#include "tumble/steady/lagrange_top.hpp"

namespace scene_chapter::work_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::Sketch;
using support::svg_number;
using support::Vec2;

enum Which { scene, asked };
constexpr std::array<Control, 2> controls{
    {{"scene", "scene", "", 0, 4, 1, 3,
      "ball, free|symmetric top, free|flipping body, free|fast top on its pivot|lopsided body on "
      "its pivot"},
     {"asked", "error asked: 10⁻ᵏ rad, k", "", 2, 10, 0.25, 6}}};

// ── What each method needs ──

/// To somewhat below the diagram: also for its last line there is a run that is good enough.
constexpr WorkRange range{1e-11, 0.1, 4e4};

struct Scene {
  Model model;
  std::optional<double> promised;  ///< by its closed form, if there is one [rad]
  std::vector<WorkCurve> curves;   ///< by steps; the last one is what the library takes
};

std::optional<double> promised_by_closed_form(const KnownTurning& known) {
  const steady::SteadyTorque torque(known.body, known.forces);
  if (torque.is_free()) {
    const Vec3 omega = derived(known.body, known.start).omega;
    return 1e-14 * std::max(1., omega.norm() * known.duration);
  }
  const auto top = steady::LagrangeTop::from(torque, known.start.q, known.start.L);
  if (!top) return std::nullopt;
  return top->error_bound(known.duration);
}

Scene scene_of(const KnownTurning& known) {
  Scene made{choose_model(known.body).model, promised_by_closed_form(known), {}};
  made.curves.push_back(by_fixed_steps(known, of_method<Rk4>(known, "RK4", 4), range));
  made.curves.push_back(by_tolerances<Dop853>(known, "DOP853", range));
  if (known.forces.at_point.empty()) return made;
  const Steps splitting = of_splitting<geometric::BlanesMoan4>(known, "splitting, order 4");
  made.curves.push_back(by_fixed_steps(known, splitting, range));
  made.curves.push_back(by_taylor(known, range));
  return made;
}

KnownTurning known_scene(std::size_t i) {
  if (i == 0) return free_turning({1, 1, 1}, {1, 2, 3}, 10);
  if (i == 1) return free_turning({1, 1, 0.5}, {1, 2, 3}, 10);
  return i == 2 ? flipping_body() : i == 3 ? fast_top() : lopsided_body();
}

/// A scene's runs are made when it is first looked at.
const Scene& the_scene(Settings now) {
  static std::array<std::optional<Scene>, 5> all;
  const auto i = static_cast<std::size_t>(now[scene]);
  if (!all[i]) all[i] = scene_of(known_scene(i));
  return *all[i];
}

// ── The diagram, both axes logarithmic ──

constexpr double left = 70, bottom = 440, per_tenfold = 92, per_digit = 42;
constexpr double least_drawn = 1e-10;
constexpr int least_digits = 1, most_digits = 10, tenfolds = 5;

/// Rounded to a hundredth of a digit: below it a browser's sine may differ.
Vec2 at(const Work& run) {
  const double digits = std::round(-100 * std::log10(run.error)) / 100;
  const double down = per_digit * (std::min<double>(digits, most_digits) - least_digits);
  return {left + per_tenfold * std::log10(run.evaluations), 20 - bottom + 9 * per_digit - down};
}

double height_of(double error) { return at({1, error}).y(); }

void draw_axes(Sketch& sketch) {
  const double right = left + per_tenfold * tenfolds, low = height_of(least_drawn),
               high = height_of(0.1);
  for (const auto& [digits, name] :
       {std::pair{2, "10⁻²"}, {4, "10⁻⁴"}, {6, "10⁻⁶"}, {8, "10⁻⁸"}, {10, "10⁻¹⁰"}}) {
    const double y = height_of(std::pow(10, -digits));
    sketch.curve({{left, y}, {right, y}}, {"grid", 1});
    sketch.words({left, y}, {-12, 6}, name, "faint", "end");
  }
  const std::array<std::string, 6> names{"1", "10", "100", "1000", "10⁴", "10⁵"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double x = left + per_tenfold * static_cast<double>(i);
    sketch.curve({{x, low}, {x, high}}, {"grid", 1});
    sketch.words({x, low}, {0, 24}, names[i], "faint", "middle");
  }
  sketch.words({left, high}, {-50, -14}, "orientation off by [rad]", "faint");
  sketch.words({right, low}, {0, 48}, "evaluations of the forces", "faint", "end");
}

constexpr std::array<const char*, 4> colours{"c0", "c3", "c1", "c2"};

/// A curve, and where it meets the error that is asked for.
void draw_curve(Sketch& sketch, const WorkCurve& curve, const std::string& colour, double error,
                bool chosen) {
  std::vector<Vec2> points;
  for (const Work& run : curve.runs) {
    if (run.error < least_drawn) break;
    points.push_back(at(run));
  }
  if (points.empty()) return;
  sketch.curve(points, {colour, chosen ? 3.2 : 1.8});
  for (const Work& run : curve.runs) {
    if (run.evaluations != curve.work_for(error)) continue;
    if (chosen) sketch.dot(at(run), "ink", 9);
    sketch.dot(at(run), colour, 6);
  }
}

/// A line of the list at the right: a method, and what it needs.
void draw_need(Sketch& sketch, int line, const std::string& name, const std::string& need,
               const std::string& colour, bool chosen) {
  const double y = -94 - 60 * line;
  sketch.words({555, y}, {0, 0}, name + (chosen ? " ←" : ""), colour);
  sketch.words({555, y}, {0, 22}, need, chosen ? "ink" : colour);
}

void draw_curves(Sketch& sketch, const Scene& shown, double error, bool closed) {
  for (std::size_t i = 0; i < shown.curves.size(); ++i) {
    const WorkCurve& curve = shown.curves[i];
    const double need = curve.work_for(error);
    const bool chosen = !closed && i + 1 == shown.curves.size();
    draw_curve(sketch, curve, colours[i], error, chosen);
    draw_need(sketch, static_cast<int>(i) + 1, curve.name,
              std::isinf(need) ? "not reached" : svg_number(need, 0), colours[i], chosen);
  }
}

/// One question, at the error that is promised.
void draw_closed_form(Sketch& sketch, const Scene& shown, bool chosen) {
  if (!shown.promised) return draw_need(sketch, 0, "closed form", "is not known", "c4", false);
  const Vec2 place = at({1, *shown.promised});
  if (chosen) sketch.dot(place, "ink", 9);
  sketch.dot(place, "c4", 6);
  draw_need(sketch, 0, "closed form", chosen ? "1" : "promises less", "c4", chosen);
}

std::string draw(Settings now) {
  Sketch sketch(760, 495, "Error against evaluations, by each method");
  const Scene& shown = the_scene(now);
  const double error = std::pow(10, -now[asked]);
  const bool closed = shown.promised && *shown.promised <= error;
  sketch.look({0, 0, 1});
  draw_axes(sketch);
  const double y = height_of(error);
  sketch.curve({{left, y}, {left + per_tenfold * tenfolds, y}}, {"c6", 1.6});
  sketch.words({left, y}, {per_tenfold + 8, -8}, "asked", "c6");
  draw_curves(sketch, shown, error, closed);
  draw_closed_form(sketch, shown, closed);
  sketch.words({555, -60}, {0, 0}, "evaluations needed");
  sketch.words({555, -420}, {0, 0}, std::string("model: ") + name_of(shown.model));
  sketch.words({555, -444}, {0, 0}, "← the library takes this");
  return sketch.svg();
}

void drag(std::span<double> settings, const Drag& pointer) {
  const double digits = least_digits + (pointer.y + height_of(0.1)) / per_digit;
  settings[asked] = allowed(controls[asked], digits);
}

}  // namespace
}  // namespace scene_chapter::work_figure

const tumble::support::MovingFigure tumble::figures::work{
    "work", scene_chapter::work_figure::controls, scene_chapter::work_figure::draw,
    scene_chapter::work_figure::drag};
