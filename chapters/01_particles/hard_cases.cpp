/// @file
/// Where the methods fail, and by how much.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "methods.hpp"
#include "parts.hpp"
#include "support/plot.hpp"
#include "thrown_ball.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

using support::error_number;
using support::number;

namespace {

using support::error_number;
using Pair = Eigen::Vector2d;

// ── Too long a step ──

/// A mass on a spring, y = (ω x, v), with ω = 1: the exact motion keeps the length of y.
Pair oscillator(double, const Pair& y) { return {y[1], -y[0]}; }

/// A speed that drag takes away at the rate 1; the second number is not used.
Pair decay(double, const Pair& y) { return {-y[0], 0}; }

/// By which factor a step of length h changes the size of the state.
template <class Method>
double growth(Pair (*f)(double, const Pair&), double h) {
  return Method::step(f, 0., Pair(1, 0), h).norm();
}

/// The longest step that does not make the state grow; 0 if even a short one does.
template <class Method>
double longest_step(Pair (*f)(double, const Pair&)) {
  double holds = 0.01, explodes = 10;
  if (growth<Method>(f, holds) > 1) return 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (holds + explodes) / 2;
    (growth<Method>(f, middle) > 1 ? explodes : holds) = middle;
  }
  return holds;
}

}  // namespace

Table limits_table() {
  Table table({"method", "mass on a spring", "drag"});
  const auto limit = [](double h, const char* unit) {
    return h == 0 ? std::string("grows at any h") : "h < " + number(h, 4) + unit;
  };
  for_each_method([&](const std::string& name, auto method, int) {
    using Method = decltype(method);
    table.add({name, limit(longest_step<Method>(oscillator), " / ω"),
               limit(longest_step<Method>(decay), " m/k")});
  });
  return table;
}

std::string growth_figure() {
  support::Plot plot{"a mass on a spring",
                     {"step times frequency, h ω"},
                     {"amplitude after one step, exact: 1"},
                     {}};
  for_each_method([&](const std::string& name, auto method, int) {
    support::Series series{name, {}, {}};
    for (int i = 0; i <= 150; ++i) {
      const double h = 0.02 * i, factor = growth<decltype(method)>(oscillator, h);
      if (factor > 2) break;
      series.x.push_back(h);
      series.y.push_back(factor);
    }
    plot.series.push_back(series);
  });
  return support::to_svg(plot);
}

Table smash_table() {
  Table table({"step", "h k |v|/m", "v after 1 step", "2 steps", "3 steps", "4 steps"});
  const ThrownBall& ball = balls.back();
  const particles::ParticleSystem system(thrown(ball.mass, 30), particles::QuadraticDrag{ball.k()});
  for (const double h : {0.05, 0.2, 0.3, 0.5, 0.6}) {
    Flight y = Flight::Zero();
    y[3] = 30;
    std::vector<std::string> row{number(h) + " s", number(h * ball.k() * 30 / ball.mass)};
    for (int i = 0; i < 4; ++i) {
      y = runge_kutta::euler_step(system, 0., y, h);
      row.push_back(number(y[3]) + " m/s");
    }
    table.add(row);
  }
  return table;
}

// ── Ends at the same place ──

Table same_place_table() {
  Table table({"from end j to i", "force by the law", "by the library"});
  for (const double x : {2., 1e-3, 1e-100, 0., -1e-100}) {
    const std::array<particles::Particle<double>, 2> ends{
        {{1, Vec3(x, 0, 0), Vec3::Zero()}, {1, Vec3::Zero(), Vec3::Zero()}}};
    const particles::ParticleSystem system(ends, particles::Spring{0, 1, 10, 0, 1});
    const double length = std::abs(x), naive = -10 * (length - 1) * (x / length);
    table.add({number(x) + " m", std::isnan(naive) ? "0/0" : number(naive) + " N",
               number(system.dydt(0, particles::flatten(ends))[3]) + " N"});
  }
  return table;
}

// ── Time ──

namespace {

/// A method whose right-hand side is told the time of the step's start, whatever the stage.
template <class Method>
struct Frozen {
  template <class F>
  static Pair step(F&& f, double t, const Pair& y, double h) {
    return Method::step([&](double, const Pair& state) -> Pair { return f(t, state); }, t, y, h);
  }
  static constexpr int order = 1;
};

/// ẍ = −x + cos 2t, from rest: x = (cos t − cos 2t)/3.
Pair pushed(double t, const Pair& y) { return {y[1], -y[0] + std::cos(2 * t)}; }

template <class Method>
double pushed_error(int steps) {
  const double end = 3, x = (std::cos(end) - std::cos(2 * end)) / 3;
  return std::abs(integrate_fixed<Method>(pushed, Pair(0, 0), 0, end, steps)[0] - x);
}

/// Errors with 64, 128 and 256 steps, and the order that they show.
std::vector<std::string> order_row(const std::string& name, double (*error)(int)) {
  std::vector<std::string> row{name};
  std::vector<double> h, errors;
  for (const int steps : {64, 128, 256}) {
    h.push_back(1. / steps);
    errors.push_back(error(steps));
    row.push_back(error_number(errors.back()) + " m");
  }
  row.push_back(number(runge_kutta::observed_order(h, errors), 2));
  return row;
}

}  // namespace

Table time_table() {
  Table table({"f is told", "64 steps", "128 steps", "256 steps", "order"});
  table.add(order_row("midpoint: t, t + h/2", pushed_error<runge_kutta::Midpoint>));
  table.add(order_row("midpoint: always t", pushed_error<Frozen<runge_kutta::Midpoint>>));
  table.add(order_row("RK4: t, t + h/2, t + h/2, t + h", pushed_error<Rk4>));
  table.add(order_row("RK4: always t", pushed_error<Frozen<Rk4>>));
  return table;
}

// ── A force that jumps ──

namespace {

/// Upwards in the air, with a motor that burns for the first of three seconds. y = (height, speed).
struct Rocket {
  bool burning;

  Pair operator()(double, const Pair& y) const {
    const double thrust = burning ? 40 : 0;  // all forces for one kilogram [N]
    return {y[1], thrust - g - 0.005 * std::abs(y[1]) * y[1]};
  }
};

Pair burnt_out(double t, const Pair& y) { return Rocket{t < 1}(t, y); }

double exact_height() {
  const Tolerances tight{1e-14, 1e-14};
  const Pair burnt = integrate_adaptive<Dop853>(Rocket{true}, Pair(0, 0), 0, 1, tight).y;
  return integrate_adaptive<Dop853>(Rocket{false}, burnt, 1, 3, tight).y[0];
}

template <class Method>
double through_the_jump(int steps) {
  return std::abs(integrate_fixed<Method>(burnt_out, Pair(0, 0), 0, 3, steps)[0] - exact_height());
}

template <class Method>
double stopping_at_the_jump(int steps) {
  const Pair burnt = integrate_fixed<Method>(Rocket{true}, Pair(0, 0), 0, 1, steps / 2);
  const Pair end = integrate_fixed<Method>(Rocket{false}, burnt, 1, 3, steps / 2);
  return std::abs(end[0] - exact_height());
}

}  // namespace

Table jump_table() {
  Table table({"method", "64 steps", "128 steps", "256 steps", "order"});
  table.add(order_row("midpoint, across the jump", through_the_jump<runge_kutta::Midpoint>));
  table.add(order_row("midpoint, a step ends there", stopping_at_the_jump<runge_kutta::Midpoint>));
  table.add(order_row("RK4, across the jump", through_the_jump<Rk4>));
  table.add(order_row("RK4, a step ends there", stopping_at_the_jump<Rk4>));
  return table;
}

}  // namespace particles_chapter
