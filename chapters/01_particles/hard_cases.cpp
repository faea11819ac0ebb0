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

using support::number;

namespace {

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
               limit(longest_step<Method>(decay), " m/β")});
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
  Table table({"step", "h γ |v|/m", "v after 1 step", "2 steps", "3 steps", "4 steps"});
  const ThrownBall& ball = balls.back();
  const particles::ParticleSystem system(thrown(ball.mass, 30),
                                         particles::QuadraticDrag{ball.gamma()});
  for (const double h : {0.05, 0.2, 0.3, 0.5, 0.6}) {
    Flight y = Flight::Zero();
    y[3] = 30;
    std::vector<std::string> row{number(h) + " s", number(h * ball.gamma() * 30 / ball.mass)};
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

}  // namespace particles_chapter
