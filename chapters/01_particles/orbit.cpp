/// @file
/// A satellite on an ellipse about the Earth: after each revolution it has to be where it was.

#include <cmath>
#include <string>
#include <vector>

#include "parts.hpp"
#include "revolutions.hpp"
#include "support/sketch.hpp"

namespace particles_chapter {

using support::error_number;
using support::number;
using support::Vec2;

namespace {

constexpr double earth_radius = 6.3781e6;  // [m]

/// Kinetic and potential energy of each kilogram [J/kg].
double energy(const Orbit& y) { return y.tail<2>().squaredNorm() / 2 - GM / y.head<2>().norm(); }

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

}  // namespace

std::string orbit_figure() {
  constexpr int turns = 5;
  const int euler_steps = turns * evaluations_a_turn, rk4_steps = euler_steps / 4;
  support::Sketch sketch(612, 480, "five revolutions of a satellite");
  sketch.look({450, 242, 1.25e-5});
  const Vec2 corner(-3.45e7, -1.75e7);
  for (const Vec2& axis : {Vec2(3.9e6, 0), Vec2(0, 3.9e6)})
    sketch.arrow(corner, corner + axis, {"faint", 1.5});
  sketch.words(corner + Vec2(3.9e6, 0), {6, 5}, "x");
  sketch.words(corner + Vec2(0, 3.9e6), {-4, -7}, "y");
  sketch.disc({0, 0}, earth_radius, "solid");
  sketch.words({0, 0}, {0, 6}, "Earth", "ink", "middle");
  const std::vector<Vec2> spiral = path<runge_kutta::Euler>(turns, euler_steps, 6);
  sketch.curve(spiral, {colour_of("Euler"), 1.5});
  sketch.curve(path<Rk4>(turns, rk4_steps, 2), {colour_of("RK4"), 2.6});
  sketch.dot({perigee, 0}, "ink");
  sketch.dot(spiral.back(), colour_of("Euler"));
  sketch.words({perigee, 0}, {28, 6}, "start");
  sketch.words({-apogee, 0}, {9, 6}, "RK4", colour_of("RK4"));
  sketch.words(spiral.back(), {8, 20}, "Euler", colour_of("Euler"));
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

Table halved_table() {
  Table table({"steps per turn", "off after 1 turn", "ratio"});
  double before = 0;
  for (int steps = evaluations_a_turn; steps <= 64 * evaluations_a_turn; steps *= 2) {
    const double off = distance(after<runge_kutta::Euler>(1, steps), at_perigee());
    table.add(
        {number(steps, 6), count(off / km, 3) + " km", before == 0 ? "" : number(before / off, 3)});
    before = off;
  }
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

}  // namespace particles_chapter
