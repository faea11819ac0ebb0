/// @file
/// Forces that look at the clock: one that changes all the time, and one that ends at once.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "methods.hpp"
#include "parts.hpp"
#include "thrown_ball.hpp"

namespace particles_chapter {

using support::error_number;
using support::number;

namespace {

using Pair = Eigen::Vector2d;

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
