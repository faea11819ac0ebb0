/// @file
/// Where each method is stable, seen by asking the method itself.

#include <cmath>
#include <complex>

#include "drawing.hpp"
#include "parts.hpp"
#include "problems.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

using support::error_number;
using support::number;

namespace {

using Complex = std::complex<double>;

/// R(z): what one step of length 1 makes of y = 1 under y' = z y. A complex number is a pair of
/// real ones.
template <class Method>
Complex stability_function(Complex z) {
  Eigen::Matrix2d turn;
  turn << z.real(), -z.imag(), z.imag(), z.real();
  const auto f = [&](double, const Vec2& y) -> Vec2 { return turn * y; };
  const auto jacobian = [&](double, const Vec2&) { return turn; };
  const Vec2 y = Method::step(with_jacobian(f, jacobian), 0.0, Vec2(1, 0), 1.0);
  return {y[0], y[1]};
}

/// How far along a direction |R| ≤ 1, starting at 0.
template <class Method>
std::string stable_length(Complex direction) {
  const auto is_stable = [&](double s) {
    return std::abs(stability_function<Method>(s * direction)) <= 1 + 1e-10;
  };
  double stable = 0;
  for (double s = 0.05; s <= 1000; s *= 1.01) {
    if (!is_stable(s)) break;
    stable = s;
  }
  if (stable == 0) return "0";
  double unstable = 1.01 * stable;
  if (unstable > 1000) return "no limit";
  for (int i = 0; i < 50; ++i) {
    const double middle = (stable + unstable) / 2;
    (is_stable(middle) ? stable : unstable) = middle;
  }
  return number(stable, 4);
}

/// The curve |R| = 1 through 0: R runs round the unit circle, z after it, by Newton's method.
template <class Method>
Path stability_boundary() {
  constexpr int points_a_turn = 48;
  Path path{Vec2(0, 0)};
  Complex z = 0;
  for (int i = 1; i < 12 * points_a_turn; ++i) {
    const Complex target = std::polar(1.0, 2 * pi * i / points_a_turn);
    for (int round = 0; round < 12; ++round) {
      const Complex d(1e-6, 0), R = stability_function<Method>(z);
      z -= (R - target) * d / (stability_function<Method>(z + d) - R);
    }
    path.emplace_back(z.real(), z.imag());
    if (i % points_a_turn == 0 && std::abs(z) < 1e-3) break;
  }
  return path;
}

}  // namespace

Table stability_table() {
  Table table({"method", "evaluations per step", "stable from 0 to −…", "to ±… i", "|R(−1000)|"});
  const auto add = [&]<class Method>(const std::string& name, const std::string& cost, Method) {
    table.add({name, cost, stable_length<Method>(-1), stable_length<Method>(Complex(0, 1)),
               error_number(std::abs(stability_function<Method>(-1000)))});
  };
  add("Euler", "1", runge_kutta::Euler{});
  add("midpoint", "2", runge_kutta::Midpoint{});
  add("RK4", "4", Rk4{});
  add("DP 5(4)", "6", DormandPrince54{});
  add("DOP853", "12", Dop853{});
  add("backward Euler", "a few, and ∂f/∂y", runge_kutta::BackwardEuler{});
  add("Radau5", "some ten, and ∂f/∂y", Radau5{});
  return table;
}

Table damped_table() {
  Table table({"method", "|R| for h = 0.01 s", "h = 0.05 s", "h = 0.2 s", "h = 0.3 s"});
  const Complex lambda(-1, std::sqrt(99.0));  // of a kilogram on 100 N/m with 2 N s/m
  const auto add = [&]<class Method>(const std::string& name, Method) {
    std::vector<std::string> row{name};
    for (const double h : {0.01, 0.05, 0.2, 0.3})
      row.push_back(number(std::abs(stability_function<Method>(h * lambda)), 3));
    table.add(row);
  };
  add("Euler", runge_kutta::Euler{});
  add("midpoint", runge_kutta::Midpoint{});
  add("RK4", Rk4{});
  add("backward Euler", runge_kutta::BackwardEuler{});
  return table;
}

std::string regions_figure() {
  support::Sketch sketch(760, 600, "where a step makes y smaller");
  look_at(sketch, {{-8, -6.5}, {8, 6.5}, 12, 8, 45});
  sketch.curves({{{-8, 0}, {8, 0}}, {{0, -6.5}, {0, 6.5}}}, {"faint", 1});
  for (const int tick : {-6, -4, 4, 6}) {
    sketch.words({tick, -0.42}, {0, 0}, number(tick), "faint", "middle");
    if (tick < 6) sketch.words({0.12, tick - 0.1}, {0, 0}, number(tick) + "i", "faint");
  }
  const auto add = [&](const Path& path, const std::string& colour, const std::string& name,
                       const Vec2& at) {
    sketch.curve(path, {colour, 1.8, 1, 0.1});
    sketch.words(at, {0, 0}, name, colour, "middle");
  };
  add(stability_boundary<Dop853>(), "c4", "DOP853", {-3.4, 4.2});
  add(stability_boundary<DormandPrince54>(), "c3", "DP 5(4)", {-3.8, 2.1});
  add(stability_boundary<Rk4>(), "c0", "RK4", {-0.6, 2.2});
  add(stability_boundary<runge_kutta::Midpoint>(), "c2", "midpoint", {-1, 1.06});
  add(stability_boundary<runge_kutta::Euler>(), "c1", "Euler", {-1, 0.3});
  add(stability_boundary<runge_kutta::BackwardEuler>(), "c6", "backward Euler: stable outside",
      {5, 0.9});
  sketch.words({7.9, -0.42}, {0, 0}, "Re z", "ink", "end");
  sketch.words({0.12, 6.15}, {0, 0}, "Im z");
  return sketch.svg();
}

}  // namespace solvers_chapter
