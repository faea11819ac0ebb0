/// @file
/// A satellite on an ellipse about the Earth: after each revolution it has to be where it was.

#include <cmath>
#include <numbers>
#include <vector>

#include "methods.hpp"
#include "parts.hpp"
#include "satellite.hpp"
#include "support/plot.hpp"
#include "support/sketch.hpp"

namespace particles_chapter {

using support::error_number;
using support::number;
using support::Vec2;

namespace {

constexpr double earth_radius = 6.3781e6;  // [m]
constexpr double km = 1000;

double period() {
  return 2 * std::numbers::pi * std::sqrt(semi_major_axis * semi_major_axis * semi_major_axis / GM);
}

double distance(const Orbit& a, const Orbit& b) { return (a - b).head<2>().norm(); }

/// Kinetic and potential energy of each kilogram [J/kg].
double energy(const Orbit& y) { return y.tail<2>().squaredNorm() / 2 - GM / y.head<2>().norm(); }

/// After so many whole revolutions the satellite is where it was at the start.
template <class Method>
Orbit after(int revolutions, int steps) {
  return integrate_fixed<Method>(rhs_from_c(satellite), at_perigee(), 0, revolutions * period(),
                                 steps);
}

// ── The same number of evaluations for each method ──

constexpr int evaluations_a_turn = 960;

template <class Method>
std::vector<Vec2> path(int revolutions, int steps, int every) {
  std::vector<Vec2> points{at_perigee().head<2>()};
  int step = 0;
  integrate_fixed<Method>(rhs_from_c(satellite), at_perigee(), 0, revolutions * period(), steps,
                          [&](double, const Orbit& y) {
                            if (++step % every == 0) points.emplace_back(y.head<2>());
                          });
  return points;
}

/// A number to so many digits, a large one filled with zeros.
std::string count(double value, int digits) {
  const double unit = std::pow(10, std::floor(std::log10(value)) + 1 - digits);
  return number(unit < 1 ? value : std::round(value / unit) * unit, unit < 1 ? digits : 7);
}

}  // namespace

std::string orbit_figure() {
  constexpr int turns = 5;
  const int euler_steps = turns * evaluations_a_turn, rk4_steps = euler_steps / 4;
  support::Sketch sketch(612, 480, "five revolutions of a satellite");
  sketch.look({450, 242, 1.25e-5});
  sketch.disc({0, 0}, earth_radius, "solid");
  sketch.words({0, 0}, {0, 6}, "Earth", "ink", "middle");
  const std::vector<Vec2> spiral = path<runge_kutta::Euler>(turns, euler_steps, 6);
  sketch.curve(spiral, {"c1", 1.5});
  sketch.curve(path<Rk4>(turns, rk4_steps, 2), {"c0", 2.6});
  sketch.dot({perigee, 0}, "ink");
  sketch.dot(spiral.back(), "c1");
  sketch.words({perigee, 0}, {28, 6}, "start");
  sketch.words({-apogee, 0}, {9, 6}, "RK4", "c0");
  sketch.words(spiral.back(), {8, 20}, "Euler", "c1");
  return sketch.svg();
}

Table orbit_table() {
  Table table({"method", "step", "off after 1 turn", "off after 5", "energy gained"});
  for_each_method([&](const std::string& name, auto method, int evaluations) {
    using Method = decltype(method);
    const int steps = evaluations_a_turn / evaluations;
    const Orbit start = at_perigee(), one = after<Method>(1, steps),
                five = after<Method>(5, 5 * steps);
    table.add({name, number(period() / steps) + " s", count(distance(one, start) / km, 3) + " km",
               count(distance(five, start) / km, 3) + " km",
               number(100 * (energy(five) / std::abs(energy(start)) + 1), 2) + " %"});
  });
  return table;
}

// ── The C interface ──

namespace {

std::vector<double> half_a_turn(double relative_tolerance) {
  const Orbit y = at_perigee();
  const std::vector<double> y0(y.begin(), y.end());
  return ode(y0, 0.0, period() / 2, satellite, {relative_tolerance, 1e-3});
}

}  // namespace

Table ode_table() {
  Table table({"tolerance", "apogee missed by", "evaluations"});
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    int evaluations = 0;
    const auto counted = [&](double t, const double y[], double ydot[]) {
      ++evaluations;
      satellite(t, y, ydot);
    };
    const Orbit y = at_perigee();
    ode(std::vector<double>(y.begin(), y.end()), 0.0, period() / 2, counted, {tolerance, 1e-3});
    const std::vector<double> end = half_a_turn(tolerance);
    const double missed = (Vec2(end[0], end[1]) - Vec2(-apogee, 0)).norm();
    table.add({error_number(tolerance), error_number(missed / km) + " km", number(evaluations)});
  }
  return table;
}

// ── Order ──

namespace {

/// The state a tenth of a revolution on, where nothing is symmetrical.
Orbit on_the_way(const Orbit& from, double time) {
  return integrate_adaptive<Dop853>(rhs_from_c(satellite), from, 0, time, {1e-14, 1e-9}).y;
}

/// How the error of one step, and of one revolution, falls with the step.
template <class Method>
std::vector<std::string> local_and_global(const std::string& name) {
  const Orbit start = on_the_way(at_perigee(), period() / 10);
  std::vector<double> steps, local, global;
  for (const int count : {1024, 2048, 4096}) {
    const double h = period() / count;
    steps.push_back(h);
    // Of one long step: the error of a short one would be lost in rounding.
    const Orbit one = Method::step(rhs_from_c(satellite), 0., start, 16 * h);
    local.push_back(distance(one, on_the_way(start, 16 * h)));
    global.push_back(distance(after<Method>(1, count), at_perigee()));
  }
  return {name,
          error_number(local[0]) + " m",
          error_number(local[1]) + " m",
          number(runge_kutta::observed_order(steps, local), 3),
          error_number(global[0]) + " m",
          error_number(global[1]) + " m",
          number(runge_kutta::observed_order(steps, global), 3)};
}

support::Series error_curve(const std::string& name, auto method, double (*abscissa)(int, int),
                            int evaluations) {
  support::Series series{name, {}, {}};
  for (int steps = 1 << 17; steps >= 64; steps /= 2) {
    series.x.push_back(abscissa(steps, evaluations));
    series.y.push_back(distance(after<decltype(method)>(1, steps), at_perigee()));
  }
  return series;
}

/// The evaluations that bring the error of a revolution down to `allowed` [m]: between two runs,
/// and beyond the longest, error = C hᵖ is believed.
template <class Method>
double price(double allowed, int evaluations) {
  int steps = 64;
  double error = distance(after<Method>(1, steps), at_perigee());
  while (error > allowed && steps < 1 << 18)
    error = distance(after<Method>(1, steps *= 2), at_perigee());
  return evaluations * steps * std::pow(error / allowed, 1.0 / Method::order);
}

}  // namespace

Table order_table() {
  Table table({"method", "a step of 1/64 turn", "of 1/128", "order", "a turn in 1024 steps",
               "in 2048", "order"});
  for_each_method([&](const std::string& name, auto method, int) {
    table.add(local_and_global<decltype(method)>(name));
  });
  return table;
}

std::string error_figure() {
  support::Plot plot{"error after one revolution",
                     {"step h [s]", support::Scale::log},
                     {"distance from where it should be [m]", support::Scale::log},
                     {}};
  for_each_method([&](const std::string& name, auto method, int evaluations) {
    const auto step = [](int steps, int) { return period() / steps; };
    plot.series.push_back(error_curve(name, method, step, evaluations));
  });
  return support::to_svg(plot);
}

std::string price_figure() {
  support::Plot plot{"error against cost, one revolution",
                     {"evaluations of the right-hand side", support::Scale::log},
                     {"distance from where it should be [m]", support::Scale::log},
                     {}};
  for_each_method([&](const std::string& name, auto method, int evaluations) {
    const auto cost = [](int steps, int each) { return 1. * steps * each; };
    plot.series.push_back(error_curve(name, method, cost, evaluations));
  });
  return support::to_svg(plot);
}

Table price_table() {
  Table table({"error of one revolution", "Euler", "midpoint", "RK4"});
  for (const double allowed : {1e5, 1e4, 1e3, 1e2, 1e1, 1e0}) {
    std::vector<std::string> row{
        (allowed < km ? number(allowed) + " m" : number(allowed / km) + " km")};
    for_each_method([&](const std::string&, auto method, int evaluations) {
      row.push_back(count(price<decltype(method)>(allowed, evaluations), 2));
    });
    table.add(row);
  }
  return table;
}

}  // namespace particles_chapter
