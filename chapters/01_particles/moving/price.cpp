/// @file
/// One revolution of the satellite by three methods that evaluate the forces equally often, and the
/// errors that this buys.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "01_particles/moving_figures.hpp"
#include "01_particles/satellite.hpp"
#include "support/sketch.hpp"

namespace particles_chapter::price_figure {

namespace {

using support::Control;
using support::Settings;
using support::Vec2;

enum Which { cost, time };
constexpr double film = 10;  // of one revolution [s]
constexpr std::array<Control, 2> controls{
    {{"cost", "evaluations, 2ᵏ, k", "", 5, 14, 0.25, 10}, {"t", "film", "s", 0, film, 0.05, 8.5}}};

/// A method as the figure shows it.
struct Shown {
  const char *name, *colour;
  int evaluations;                        ///< of the forces, in a step
  std::vector<Orbit> (*revolution)(int);  ///< in so many steps
};

template <class Method>
std::vector<Orbit> revolution(int steps) {
  std::vector<Orbit> places{at_perigee()};
  integrate_fixed<Method>(rhs_from_c(satellite), at_perigee(), 0, period(), steps,
                          [&](double, const Orbit& y) { places.push_back(y); });
  return places;
}

constexpr std::array<Shown, 3> methods{{{"Euler", "c1", 1, revolution<runge_kutta::Euler>},
                                        {"midpoint", "c2", 2, revolution<runge_kutta::Midpoint>},
                                        {"RK4", "c0", 4, revolution<Rk4>}}};

double error_of(const std::vector<Orbit>& places) {
  return (places.back() - at_perigee()).head<2>().norm();
}

// ── The diagram of errors against their price, both logarithmic ──

constexpr double left = 480, bottom = 400, per_doubling = 19, per_decade = 25;
constexpr int first_doubling = 5, doublings = 13, first_decade = -6, decades = 15;

Vec2 in_diagram(double evaluations, double error) {
  const double across = per_doubling * (std::log2(evaluations) - first_doubling);
  const double up = per_decade * (std::log10(std::max(error, 1e-9)) - first_decade);
  return {left + across, -bottom + std::max(0., up)};
}

/// The error at 2^k evaluations.
using Curve = std::array<Vec2, doublings + 1>;

const std::array<Curve, 3>& curves() {
  static const std::array<Curve, 3> all = [] {
    std::array<Curve, 3> made;
    for (std::size_t m = 0; m < 3; ++m)
      for (int k = 0; k <= doublings; ++k) {
        const int evaluations = 1 << (first_doubling + k);
        const int steps = evaluations / methods[m].evaluations;
        made[m][static_cast<std::size_t>(k)] =
            in_diagram(evaluations, error_of(methods[m].revolution(steps)));
      }
    return made;
  }();
  return all;
}

void draw_axes(support::Sketch& sketch, double evaluations) {
  const double right = left + per_doubling * doublings, top = -bottom + per_decade * decades;
  const double here = in_diagram(evaluations, 1).x();
  sketch.curve({{left, top}, {left, -bottom}, {right, -bottom}}, {"faint", 1});
  for (const auto& [decade, name] :
       {std::pair{-3, "1 mm"}, {0, "1 m"}, {3, "1 km"}, {6, "1000 km"}}) {
    const double y = -bottom + per_decade * (decade - first_decade);
    sketch.curve({{left, y}, {right, y}}, {"grid", 1});
    sketch.words({left, y}, {-6, 5}, name, "faint", "end");
  }
  sketch.curve({{here, top}, {here, -bottom}}, {"ink", 1, 0.5});
  sketch.words({here, -bottom}, {0, 22}, support::svg_number(evaluations, 0), "ink", "middle");
  sketch.words({(left + right) / 2, -bottom}, {0, 46}, "evaluations of the forces", "faint",
               "middle");
}

// ── The revolutions ──

/// How far off, in words.
std::string length_text(double metres) {
  if (metres >= 1e4) return support::svg_number(metres / 1000, 0) + " km off";
  if (metres >= 10) return support::svg_number(metres, 0) + " m off";
  return support::svg_number(metres, 3) + " m off";
}

void draw_revolution(support::Sketch& sketch, const Shown& method, double evaluations, double part,
                     double line) {
  constexpr double scale = 0.85e-5;  // [px/m]
  constexpr std::size_t drawn = 400;
  const auto places = method.revolution(static_cast<int>(evaluations) / method.evaluations);
  const std::size_t stride = std::max<std::size_t>(1, places.size() / drawn);
  const auto at = [&](std::size_t i) -> Vec2 { return scale * places[i].head<2>(); };
  std::vector<Vec2> path;
  for (std::size_t i = 0; i < places.size(); i += stride) path.push_back(at(i));
  path.push_back(at(places.size() - 1));
  const std::string colour = method.colour;
  sketch.look({300, 190, 1});
  sketch.curve(path, {colour, 1.8});
  sketch.dot(at(static_cast<std::size_t>(part * static_cast<double>(places.size() - 1))), colour,
             6);
  const double error = error_of(places);
  sketch.look({0, 0, 1});
  sketch.dot(in_diagram(evaluations, error), colour, 6);
  sketch.words({20, -bottom - line}, {0, 0}, std::string(method.name) + ": " + length_text(error),
               colour);
}

std::string draw(Settings now) {
  support::Sketch sketch(760, 470, "one revolution by three methods at the same price", 16);
  // A multiple of 4: whole steps of each method.
  const double evaluations = 4 * std::round(std::exp2(now[cost]) / 4);
  sketch.look({300, 190, 1});
  sketch.disc({0, 0}, 54.2, "solid");
  sketch.words({0, 0}, {0, 6}, "Earth", "ink", "middle");
  sketch.dot({59.5, 0}, "ink", 3);
  sketch.look({0, 0, 1});
  draw_axes(sketch, evaluations);
  for (std::size_t m = 0; m < 3; ++m) {
    const Curve& curve = curves()[m];
    sketch.curve({curve.begin(), curve.end()}, {methods[m].colour, 1.6, 0.8});
  }
  for (std::size_t m = 0; m < 3; ++m)
    draw_revolution(sketch, methods[m], evaluations, now[time] / film,
                    22 * (static_cast<double>(m) + 1));
  return sketch.svg();
}

}  // namespace
}  // namespace particles_chapter::price_figure

const tumble::support::MovingFigure tumble::figures::price{
    "price", particles_chapter::price_figure::controls, particles_chapter::price_figure::draw,
    nullptr, particles_chapter::price_figure::time};
