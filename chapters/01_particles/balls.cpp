/// @file
/// Balls thrown alike, with and without air.

#include <string>
#include <vector>

#include "methods.hpp"
#include "parts.hpp"
#include "support/plot.hpp"
#include "thrown_ball.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

using support::number;

namespace {

constexpr double flight_step = 1.0 / 64;  // [s]

/// The states from the throw to the ground. The last step is shortened until it ends there.
std::vector<Flight> flown(const ThrownBall& ball, double speed) {
  const auto system = flight(ball, speed);
  std::vector<Flight> states{particles::flatten(thrown(ball.mass, speed))};
  const auto next = [&](double step) {
    return runge_kutta::rk4_step(system, 0., states.back(), step);
  };
  while (next(flight_step).z() > 0) states.push_back(next(flight_step));
  double above = 0, below = flight_step;
  for (int i = 0; i < 60; ++i) {
    const double middle = (above + below) / 2;
    (next(middle).z() > 0 ? above : below) = middle;
  }
  states.push_back(next(above));
  return states;
}

double range(const ThrownBall& ball, double speed) { return flown(ball, speed).back().x(); }

support::Series path_of(const ThrownBall& ball, double speed) {
  support::Series series{ball.name, {}, {}};
  for (const Flight& y : flown(ball, speed)) {
    series.x.push_back(y.x());
    series.y.push_back(y.z());
  }
  return series;
}

}  // namespace

Table balls_table() {
  Table table(
      {"ball", "mass [kg]", "⌀ [m]", "c_d", "thrown at", "without air", "in air", "terminal"});
  const auto add = [&](const ThrownBall& ball, double speed) {
    table.add({ball.name, number(ball.mass), number(ball.diameter), number(ball.drag),
               number(speed) + " m/s", number(speed * speed / g) + " m",
               number(range(ball, speed)) + " m", number(ball.terminal_speed()) + " m/s"});
  };
  for (const ThrownBall& ball : balls) add(ball, 30);
  add(balls[1], 70);
  return table;
}

std::string balls_figure() {
  support::Plot plot{"the same throw, 30 m/s at 45°",
                     {"distance [m]"},
                     {"height [m]"},
                     {},
                     support::Aspect::equal};
  ThrownBall nothing{"without air", 1, 0.1, 0};
  plot.series.push_back(path_of(nothing, 30));
  for (const ThrownBall& ball : balls) plot.series.push_back(path_of(ball, 30));
  return support::to_svg(plot);
}

}  // namespace particles_chapter
