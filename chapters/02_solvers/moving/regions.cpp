/// @file
/// Figure 2.5, and what a reader can move in it: z in the plane, and the method.

#include <array>
#include <cmath>
#include <string>

#include "02_solvers/moving_figures.hpp"
#include "02_solvers/stability_function.hpp"
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
constexpr double step_width = 18, unit_height = 62, steps_width = steps * step_width;
constexpr double steps_left = 20, steps_middle = 742;

std::string tick_name(int tick) { return (tick < 0 ? "−" : "") + std::to_string(std::abs(tick)); }

void draw_plane(support::Sketch& sketch) {
  look_at(sketch, plane);
  sketch.curves({{{-8, 0}, {8, 0}}, {{0, -6.5}, {0, 6.5}}}, {"faint", 1});
  for (const int tick : {-6, -4, 4, 6}) {
    sketch.words({tick, -0.42}, {0, 0}, tick_name(tick), "faint", "middle");
    if (tick < 6) sketch.words({0.12, tick - 0.1}, {0, 0}, tick_name(tick) + "i", "faint");
  }
  // Large regions first, so that none is covered.
  for (const std::size_t i : {4U, 3U, 2U, 1U, 0U, 5U}) {
    const Shown& method = methods()[i];
    sketch.curve(method.border, {std::string(method.colour), 1.8, 1, 0.1});
    sketch.words(method.name_at, {0, 0}, std::string(method.name), std::string(method.colour),
                 "middle");
  }
  sketch.words({7.9, -0.42}, {0, 0}, "Re z", "ink", "end");
  sketch.words({0.12, 6.15}, {0, 0}, "Im z");
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

std::string size_of(Complex factor) {
  const double size = std::abs(factor);
  return size < 1e6 ? svg_number(size, 3) : "more than a million";
}

void draw_steps(support::Sketch& sketch, Complex z, const Shown& method) {
  constexpr int fine = 8;  // points of the exact curve per step
  sketch.look({steps_left, steps_middle, 1});
  sketch.curve({{0, 0}, {steps_width, 0}}, {"faint", 1});
  const Complex factor = method.factor(z);
  sketch.curve(over_steps(powers(std::exp(z / static_cast<double>(fine)), fine * steps), 1. / fine),
               {"ink", 1.2, 0.6});
  const std::string colour(method.colour);
  const Path dots = over_steps(powers(factor, steps), 1);
  sketch.curve(dots, {colour, 1.2, 0.7});
  sketch.dots(dots, colour, 3.2);
  if (dots.size() <= steps)
    sketch.words({steps_width, 76}, {0, 0},
                 "step " + std::to_string(dots.size()) + " leaves the picture", colour, "end");
  const std::string exact = size_of(std::exp(z));
  sketch.words({0, 117}, {0, 0},
               "40 steps, z = " + text_of(z) + ": each multiplies y by |R| = " + size_of(factor) +
                   ", exactly |eᶻ| = " + exact + ".");
}

std::string draw(Settings now) {
  support::Sketch sketch(760, 850, "where a step makes y smaller, and what forty steps do");
  const Complex z(now[0], now[1]);
  const Shown& method = methods()[static_cast<std::size_t>(now[2])];
  draw_plane(sketch);
  sketch.dot({z.real(), z.imag()}, "ink", 7);
  sketch.dot({z.real(), z.imag()}, std::string(method.colour), 4.5);
  sketch.words({z.real(), z.imag()}, {10, -8}, "z = hλ");
  sketch.grip({{z.real(), z.imag()}});
  draw_steps(sketch, z, method);
  return sketch.svg();
}

void drag(std::span<double> settings, const Drag& pointer) {
  const support::Window window = plane.window();
  settings[0] = allowed(controls[0], (pointer.x - window.x) / window.scale);
  settings[1] = allowed(controls[1], (window.y - pointer.y) / window.scale);
}

}  // namespace

}  // namespace solvers_chapter::regions_figure

const tumble::support::MovingFigure tumble::figures::regions{
    "regions", solvers_chapter::regions_figure::controls, solvers_chapter::regions_figure::draw,
    solvers_chapter::regions_figure::drag};
