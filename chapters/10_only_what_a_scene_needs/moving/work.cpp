/// @file
/// Figure 10.10: error against evaluations of the forces. A reader chooses the scene and asks for
/// an error; the figure says what each method needs for it, and which one the library takes.

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "10_only_what_a_scene_needs/moving_figures.hpp"
#include "10_only_what_a_scene_needs/work_scenes.hpp"
#include "support/scene_for_reader.hpp"
#include "support/sketch.hpp"

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

/// A scene's runs are made when it is first looked at.
const Scene& the_scene(Settings now) {
  static std::array<std::optional<Scene>, 5> all;
  const auto i = static_cast<std::size_t>(now[scene]);
  if (!all[i]) all[i] = scene_of(known_scene(i));
  return *all[i];
}

// ── By the reader's simulate (9.5) ──

/// The runs of the reader's functions, or none.
std::vector<Work>& readers_runs() {
  static std::vector<Work> all;
  return all;
}

std::vector<double> question(Settings now) {
  const KnownTurning known = known_scene(static_cast<std::size_t>(now[scene]));
  const auto& forces = known.forces.at_point;
  std::vector<double> all = support::scene_for_reader(
      known.body, known.start, known.duration,
      forces.empty() ? SteadyForces::AtPoint{Vec3::Zero(), Vec3::Zero()} : forces.front());
  for (double steps = 20; 4 * steps < range.most_evaluations; steps *= 1.5)
    all.push_back(std::floor(steps));
  return all;
}

void take(Settings now, std::span<const double> answer) {
  constexpr std::size_t size = 5;  // of a run: evaluations, and q as it ended
  const KnownTurning known = known_scene(static_cast<std::size_t>(now[scene]));
  WorkCurve curve;
  for (std::size_t i = 0; i + size <= answer.size(); i += size) {
    const double* run = answer.data() + i;
    const Quat q = Quat(run[1], run[2], run[3], run[4]).normalized();
    range.keep(curve, {run[0], end_error(known, q)});
  }
  readers_runs() = curve.runs;
}

constexpr support::ReadersAnswer by_reader{"work", question, take};

// ── The diagram, both axes logarithmic ──

constexpr double left = 70, bottom = 440, per_tenfold = 92, per_digit = 34;
constexpr double least_drawn = 1e-12;
constexpr int least_digits = 1, most_digits = 12, tenfolds = 5;

/// Rounded to a hundredth of a digit: below it a browser's sine may differ.
Vec2 at(const Work& run) {
  const double digits = std::round(-100 * std::log10(run.error)) / 100;
  const double down = per_digit * (std::min<double>(digits, most_digits) - least_digits);
  return {left + per_tenfold * std::log10(run.evaluations),
          20 - bottom + per_digit * (most_digits - least_digits) - down};
}

double height_of(double error) { return at({1, error}).y(); }

void draw_axes(Sketch& sketch) {
  const double right = left + per_tenfold * tenfolds, low = height_of(least_drawn),
               high = height_of(0.1);
  for (const auto& [digits, name] : {std::pair{2, "10⁻²"},
                                     {4, "10⁻⁴"},
                                     {6, "10⁻⁶"},
                                     {8, "10⁻⁸"},
                                     {10, "10⁻¹⁰"},
                                     {12, "10⁻¹²"}}) {
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
constexpr const char* readers_colour = "c5";

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
  const double y = -94 - 54 * line;
  sketch.words({555, y}, {0, 0}, name + (chosen ? " ←" : ""), colour);
  sketch.words({555, y}, {0, 22}, need, chosen ? "ink" : colour);
}

/// A curve, and its line of the list.
void draw_method(Sketch& sketch, int line, const WorkCurve& curve, const std::string& colour,
                 double error, bool chosen) {
  const double need = curve.work_for(error);
  draw_curve(sketch, curve, colour, error, chosen);
  draw_need(sketch, line, curve.name, std::isinf(need) ? "not reached" : svg_number(need, 0),
            colour, chosen);
}

void draw_curves(Sketch& sketch, const Scene& shown, double error, bool closed) {
  int line = 1;
  for (std::size_t i = 0; i < shown.curves.size(); ++i)
    draw_method(sketch, line++, shown.curves[i], colours[i], error,
                !closed && i + 1 == shown.curves.size());
  if (!readers_runs().empty())
    draw_method(sketch, line, {"your simulate", readers_runs()}, readers_colour, error, false);
}

/// Drawn at one evaluation, as a logarithm has no 0, at the error that is promised.
void draw_closed_form(Sketch& sketch, const Scene& shown, bool chosen) {
  if (!shown.promised) return draw_need(sketch, 0, "closed form", "is not known", "c4", false);
  const Vec2 place = at({1, *shown.promised});
  if (chosen) sketch.dot(place, "ink", 9);
  sketch.dot(place, "c4", 6);
  draw_need(sketch, 0, "closed form", chosen ? "0" : "promises less", "c4", chosen);
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
  sketch.grip({{left, y}, {left + per_tenfold * tenfolds, y}}, 18);
  sketch.words({555, -60}, {0, 0}, "evaluations needed");
  sketch.words({555, -420}, {0, 0}, std::string("model: ") + name_of(shown.model));
  sketch.words({555, -396}, {0, 0}, "← the library takes this");
  return sketch.svg();
}

void drag(std::span<double> settings, const Drag& pointer) {
  const double digits = least_digits + (pointer.y + height_of(0.1)) / per_digit;
  settings[asked] = allowed(controls[asked], digits);
}

}  // namespace
}  // namespace scene_chapter::work_figure

const tumble::support::MovingFigure tumble::figures::work{"work",
                                                          scene_chapter::work_figure::controls,
                                                          scene_chapter::work_figure::draw,
                                                          scene_chapter::work_figure::drag,
                                                          -1,
                                                          &scene_chapter::work_figure::by_reader};
