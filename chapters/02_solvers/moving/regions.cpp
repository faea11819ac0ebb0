/// @file
/// Figure 2.5, and what a reader can move in it: z in the plane, and the method.

#include <array>
#include <cmath>
#include <string>

#include "02_solvers/moving_figures.hpp"
#include "02_solvers/stability_function.hpp"
#include "support/axis.hpp"
#include "tumble/ode/backward_euler.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/dormand_prince_54.hpp"
#include "tumble/ode/euler.hpp"
#include "tumble/ode/midpoint.hpp"
#include "tumble/ode/rk4.hpp"

namespace solvers_chapter::regions_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::svg_number;

/// A method as the figure shows it.
struct Shown {
  std::string_view name, colour;
  Vec2 name_at;
  Complex (*factor)(Complex);
  Path border;
};

template <class Method>
Shown shown(std::string_view name, std::string_view colour, const Vec2& name_at) {
  return {name, colour, name_at, stability_function<Method>,
          stability_boundary(stability_function<Method>)};
}

/// In the order of the control.
const std::array<Shown, 6>& methods() {
  static const std::array<Shown, 6> all{
      shown<tumble::runge_kutta::Euler>("Euler", "c1", {-1, 0.3}),
      shown<tumble::runge_kutta::Midpoint>("midpoint", "c2", {-1, 1.06}),
      shown<tumble::Rk4>("RK4", "c0", {-0.6, 2.2}),
      shown<tumble::DormandPrince54>("DP 5(4)", "c3", {-3.8, 2.1}),
      shown<tumble::Dop853>("DOP853", "c4", {-3.4, 4.2}),
      shown<tumble::runge_kutta::BackwardEuler>("backward Euler: stable outside", "c6", {5, 0.9})};
  return all;
}

constexpr std::array<Control, 3> controls{
    {{"re", "Re z", "", -8, 8, 0.01, -0.2},
     {"im", "Im z", "", -6.5, 6.5, 0.01, 1.99},
     {"method", "method", "", 0, 5, 1, 2, "Euler|midpoint|RK4|DP 5(4)|DOP853|backward Euler"}}};
constexpr int steps = 40;
const Cutout plane{{-8, -6.5}, {8, 6.5}, 12, 8, 45};
/// Below it the steps: how far apart they are, and how high 1 is [px].
constexpr double step_width = 17.5, unit_height = 62, steps_width = steps * step_width;
constexpr double steps_left = 40, steps_middle = 772;

/// One digit and a power of ten, for a size between 0 and 1.
std::string in_powers(double size) {
  int exponent = 0;
  for (; size < 0.95; size *= 10) --exponent;
  return svg_number(size, 0) + "·" + support::power_of_ten(exponent);
}

std::string tick_name(int tick) { return (tick < 0 ? "−" : "") + std::to_string(std::abs(tick)); }

void draw_axes(support::Sketch& sketch) {
  look_at(sketch, plane);
  std::vector<Path> ticks{{{-8, 0}, {8, 0}}, {{0, -6.5}, {0, 6.5}}};
  for (double tick = -6; tick <= 6; tick += 2) {
    ticks.push_back({{tick, -6.5}, {tick, -6.35}});
    ticks.push_back({{0, tick}, {0.15, tick}});
  }
  sketch.curves(ticks, {"faint", 1});
  for (const int tick : {-6, -4, -2, 0, 2, 4, 6}) {
    sketch.words({tick, -6.5}, {0, 19}, tick_name(tick), "faint", "middle");
    if (tick != 0) sketch.words({-8, tick}, {6, 6}, tick_name(tick) + "i", "faint");
  }
}

/// @param chosen among the methods: its region stands out
void draw_regions(support::Sketch& sketch, std::size_t chosen) {
  // Large regions first, so that none is covered.
  for (const std::size_t i : {4U, 3U, 2U, 1U, 0U, 5U}) {
    const Shown& method = methods()[i];
    const bool stands_out = i == chosen;
    sketch.curve(method.border,
                 {std::string(method.colour), stands_out ? 3.4 : 1.4, 1, stands_out ? 0.3 : 0.07});
  }
  for (const Shown& method : methods())
    sketch.words(method.name_at, {0, 0}, std::string(method.name), std::string(method.colour),
                 "middle");
  sketch.words({7.9, -0.42}, {0, 0}, "Re z", "ink", "end");
  sketch.words({0.12, 6.15}, {0, 0}, "Im z");
}

/// The dot, and its name on the side where there is room for it.
void draw_z(support::Sketch& sketch, Complex z, const std::string& colour) {
  const Vec2 at(z.real(), z.imag());
  sketch.dot(at, "ink", 7);
  sketch.dot(at, colour, 4.5);
  const bool by_axis_name = z.imag() > 5.4 && std::abs(z.real()) < 1.5;
  const bool left = z.real() > 6 || by_axis_name;
  const double down = by_axis_name ? 6 : z.imag() > 5.9 ? 20 : -8;
  sketch.words(at, {left ? -12. : 12., down}, "z = hλ", "ink", left ? "end" : "start");
  sketch.grip({at});
}

/// What is drawn below: y over the number of the step, as long as it stays in the figure.
Path over_steps(const std::vector<double>& y, double step) {
  constexpr double highest = 1.55;
  Path path;
  for (std::size_t i = 0; i < y.size() && std::abs(y[i]) <= highest; ++i)
    path.emplace_back(static_cast<double>(i) * step * step_width, y[i] * unit_height);
  return path;
}

/// The real parts of 1, factor, factor², …
std::vector<double> powers(Complex factor, int count) {
  std::vector<double> y;
  Complex now = 1;
  for (int i = 0; i <= count; ++i, now *= factor) y.push_back(now.real());
  return y;
}

std::string text_of(Complex z) {
  const std::string sign = z.imag() < 0 ? " − " : " + ";
  return (z.real() < 0 ? "−" : "") + svg_number(std::abs(z.real()), 2) + sign +
         svg_number(std::abs(z.imag()), 2) + "i";
}

/// A size by which y is multiplied. Near 1 it says on which side, since forty steps show it.
std::string size_of(Complex factor) {
  const double size = std::abs(factor), above_1 = size - 1;
  if (size > 1e6) return "more than a million";
  if (size > 0 && size < 5e-3) return in_powers(size);
  if (std::abs(above_1) < 1e-14 || std::abs(above_1) >= 5e-3)
    return svg_number(size, size < 10 ? 3 : 1);
  return (above_1 < 0 ? "1 − " : "1 + ") + in_powers(std::abs(above_1));
}

/// Which of the two paths leave the picture, and in which step.
std::string leaving(const Path& dots, const Path& exact, std::size_t points_per_step) {
  const std::size_t dots_step = dots.size(),
                    exact_step = (exact.size() + points_per_step - 1) / points_per_step;
  const bool dots_leave = dots_step <= steps, exact_leaves = exact_step <= steps;
  const auto in = [](std::size_t step) { return " in step " + std::to_string(step); };
  if (dots_leave && exact_leaves)
    return "dots leave the picture" + in(dots_step) + ", exact curve" + in(exact_step);
  if (dots_leave) return "dots leave the picture" + in(dots_step);
  return exact_leaves ? "exact curve leaves the picture" + in(exact_step) : "";
}

/// Below the plane: a ruler for y and for the number of the step.
void draw_rulers(support::Sketch& sketch) {
  std::vector<Path> lines{{{0, 0}, {steps_width, 0}}};
  for (const int y : {-1, 1}) {
    lines.push_back({{-5, y * unit_height}, {0, y * unit_height}});
    sketch.words({0, y * unit_height}, {-9, 6}, tick_name(y), "faint", "end");
  }
  sketch.words({0, 0}, {-9, 6}, "y", "ink", "end");
  for (int step = 10; step <= steps; step += 10) {
    lines.push_back({{step * step_width, -unit_height}, {step * step_width, -unit_height - 5}});
    sketch.words({step * step_width, -unit_height}, {0, 22},
                 (step == 10 ? "step " : "") + std::to_string(step), "faint",
                 step == steps ? "end" : "middle");
  }
  lines.push_back({{0, -unit_height}, {steps_width, -unit_height}});
  sketch.curves(lines, {"faint", 1});
}

void draw_steps(support::Sketch& sketch, Complex z, const Shown& method) {
  constexpr int fine = 8;  // points of the exact curve per step
  sketch.look({steps_left, steps_middle, 1});
  draw_rulers(sketch);
  const Complex factor = method.factor(z);
  const Path exact =
      over_steps(powers(std::exp(z / static_cast<double>(fine)), fine * steps), 1. / fine);
  sketch.curve(exact, {"ink", 1.2, 0.6});
  const std::string colour(method.colour);
  const Path dots = over_steps(powers(factor, steps), 1);
  sketch.curve(dots, {colour, 1.2, 0.7});
  sketch.dots(dots, colour, 3.2);
  sketch.words({steps_width, 76}, {0, 0}, leaving(dots, exact, fine), colour, "end");
  sketch.words({-28, 117}, {0, 0},
               "z = " + text_of(z) + ": each step multiplies |y| by |R| = " + size_of(factor) +
                   ", exactly by |eᶻ| = " + size_of(std::exp(z)) + ".");
}

std::string draw(Settings now) {
  support::Sketch sketch(760, 880, "where a step makes y smaller, and what forty steps do");
  const Complex z(now[0], now[1]);
  const auto chosen = static_cast<std::size_t>(now[2]);
  draw_axes(sketch);
  draw_regions(sketch, chosen);
  draw_z(sketch, z, std::string(methods()[chosen].colour));
  draw_steps(sketch, z, methods()[chosen]);
  return sketch.svg();
}

/// A pointer near an axis means the axis.
double caught_by_axis(double value) { return std::abs(value) < 0.07 ? 0 : value; }

void drag(std::span<double> settings, const Drag& pointer) {
  const support::Window window = plane.window();
  const Complex z((pointer.x - window.x) / window.scale, (window.y - pointer.y) / window.scale);
  settings[0] = allowed(controls[0], caught_by_axis(z.real()));
  settings[1] = allowed(controls[1], caught_by_axis(z.imag()));
}

}  // namespace

}  // namespace solvers_chapter::regions_figure

const tumble::support::MovingFigure tumble::figures::regions{
    "regions", solvers_chapter::regions_figure::controls, solvers_chapter::regions_figure::draw,
    solvers_chapter::regions_figure::drag};
