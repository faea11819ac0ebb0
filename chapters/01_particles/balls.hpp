#pragma once
/// @file
/// Balls thrown alike, with and without air.
///
/// Sources: mass and size from the rules of the sports (World Athletics, R&A and USGA, ITF, ITTF);
/// coefficients of drag from Mehta, "Aerodynamics of sports balls", Annual Review of Fluid
/// Mechanics 17 (1985) 151–189, of the tennis ball from Mehta, Alam & Subic, "Review of tennis ball
/// aerodynamics", Sports Technology 1 (2008) 7–16, and of a smooth sphere from Hoerner,
/// "Fluid-Dynamic Drag" (1965), chapter III.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "methods.hpp"
#include "support/plot.hpp"
#include "support/table.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

using support::number;
using support::Table;

constexpr double air = 1.225;  // density at sea level [kg/m³]
constexpr double g = 9.81;     // [m/s²]

/// A ball as the air meets it.
struct ThrownBall {
  std::string name;
  double mass, diameter, drag;  // [kg], [m], coefficient of drag

  /// ½ ρ c_d A [kg/m]
  double k() const { return air * drag * std::numbers::pi * diameter * diameter / 8; }
  /// Where drag carries the weight [m/s].
  double terminal_speed() const { return std::sqrt(mass * g / k()); }
};

const std::vector<ThrownBall> balls{{"shot", 7.26, 0.12, 0.47},
                                    {"golf ball", 0.0459, 0.0427, 0.25},
                                    {"tennis ball", 0.058, 0.067, 0.6},
                                    {"table-tennis ball", 0.0027, 0.040, 0.47}};

constexpr double flight_step = 1.0 / 64;  // [s]

/// From the origin, upwards at 45°.
inline std::array<Particle<double>, 1> thrown(double mass, double speed) {
  return {{{mass, Vec3::Zero(), Vec3(1, 0, 1).normalized() * speed}}};
}

inline auto flight(const ThrownBall& ball, double speed) {
  return ParticleSystem(thrown(ball.mass, speed), UniformGravity{{0, 0, -g}},
                        QuadraticDrag{ball.k()});
}

using Flight = Eigen::Matrix<double, 6, 1>;

/// The states from the throw to the ground. The last step is shortened until it ends there.
inline std::vector<Flight> flown(const ThrownBall& ball, double speed) {
  const auto system = flight(ball, speed);
  std::vector<Flight> states{flatten(thrown(ball.mass, speed))};
  const auto next = [&](double step) { return rk4_step(system, 0., states.back(), step); };
  while (next(flight_step).z() > 0) states.push_back(next(flight_step));
  double above = 0, below = flight_step;
  for (int i = 0; i < 60; ++i) {
    const double middle = (above + below) / 2;
    (next(middle).z() > 0 ? above : below) = middle;
  }
  states.push_back(next(above));
  return states;
}

inline double range(const ThrownBall& ball, double speed) { return flown(ball, speed).back().x(); }

inline Table balls_table() {
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

inline support::Series path_of(const ThrownBall& ball, double speed) {
  support::Series series{ball.name, {}, {}};
  for (const Flight& y : flown(ball, speed)) {
    series.x.push_back(y.x());
    series.y.push_back(y.z());
  }
  return series;
}

inline std::string balls_figure() {
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
