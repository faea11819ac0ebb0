/// @file
/// What breaks adaptive, implicit and observed.

#include <cmath>

#include "mild_orbit.hpp"
#include "parts.hpp"
#include "problems.hpp"

namespace solvers_chapter {

using support::error_number;
using support::number;

// ── What breaks ──

namespace {

/// The order seen from three runs.
template <class Error>
double order_from(const std::array<int, 3>& steps, Error&& error) {
  std::array<double, 3> h{}, errors{};
  for (std::size_t i = 0; i < 3; ++i) {
    h[i] = 1.0 / steps[i];
    errors[i] = error(steps[i]);
  }
  return runge_kutta::observed_order(h, errors);
}

/// The error of Radau5 on y' = −stiffness (y − cos t) − sin t, which cos t solves.
double driven_error(double stiffness, int steps) {
  using Vec1 = Eigen::Matrix<double, 1, 1>;
  const auto driven = [&](double t, const Vec1& y) {
    return Vec1(-stiffness * (y[0] - std::cos(t)) - std::sin(t));
  };
  const auto dfdy = [&](double, const Vec1&) { return Vec1(-stiffness); };
  const Vec1 end = integrate_fixed<Radau5>(with_jacobian(driven, dfdy), Vec1(1.0), 0.0, 2.0, steps);
  return std::abs(end[0] - std::cos(2.0));
}

}  // namespace

Table kink_table() {
  using Vec1 = Eigen::Matrix<double, 1, 1>;
  constexpr double stop = 1.0 / 3;
  const auto burning = [](double t, const Vec1&) { return Vec1(1 + std::sin(9 * t)); };
  const auto off = [](double, const Vec1&) { return Vec1(0.0); };
  const auto both = [&](double t, const Vec1& y) { return t < stop ? burning(t, y) : off(t, y); };
  const double exact = stop + (1 - std::cos(9 * stop)) / 9;
  const Tolerances tolerances{1e-9, 1e-9};
  const Vec1 start(0.0);

  Table table({"the engine's stop", "kept", "rejected", "evaluations", "error"});
  const auto add = [&](const std::string& name, const OdeSolution<Vec1>& s) {
    table.add({name, std::to_string(s.steps), std::to_string(s.rejected),
               std::to_string(s.evaluations), error_or_rounding(std::abs(s.y[0] - exact))});
  };
  add("inside a step", integrate_adaptive<DormandPrince54>(both, start, 0.0, 1.0, tolerances));
  auto first = integrate_adaptive<DormandPrince54>(burning, start, 0.0, stop, tolerances);
  const auto second = integrate_adaptive<DormandPrince54>(off, first.y, stop, 1.0, tolerances);
  add("between two integrations",
      {second.y, first.steps + second.steps, first.rejected + second.rejected,
       first.evaluations + second.evaluations});
  return table;
}

Table pulse_table() {
  using Vec1 = Eigen::Matrix<double, 1, 1>;
  constexpr double middle = 5, width = 0.01;
  const auto pulse = [](double t, const Vec1&) {
    const double s = (t - middle) / width;
    return Vec1(std::exp(-s * s) / (width * std::sqrt(pi)));
  };
  Table table({"from 0 s to 10 s", "steps", "evaluations", "area"});
  const auto whole = integrate_adaptive<DormandPrince54>(pulse, Vec1(0.0), 0.0, 10.0);
  const auto first = integrate_adaptive<DormandPrince54>(pulse, Vec1(0.0), 0.0, middle);
  const auto second = integrate_adaptive<DormandPrince54>(pulse, first.y, middle, 10.0);
  table.add({"in one go", std::to_string(whole.steps + whole.rejected),
             std::to_string(whole.evaluations), number(whole.y[0], 6)});
  table.add({"to 5 s, and on from there",
             std::to_string(first.steps + first.rejected + second.steps + second.rejected),
             std::to_string(first.evaluations + second.evaluations), number(second.y[0], 6)});
  return table;
}

Table rest_table() {
  const auto spring = [](double, const Vec2& y) -> Vec2 {
    return {y[1], gravity - 49 * y[0] - 3 * y[1]};
  };
  Table table({"absolute tolerance", "evaluations in 60 s"});
  for (const double absolute : {1e-9, 1e-12, 1e-15, 1e-21}) {
    const int evaluations =
        integrate_adaptive<DormandPrince54>(spring, Vec2(0, 0), 0.0, 60.0, {1e-6, absolute})
            .evaluations;
    table.add({number(absolute),  // of the last, rounding decides the digits
               evaluations > 100'000 ? "> 100000" : std::to_string(evaluations)});
  }
  return table;
}

Table floor_table() {
  Table table({"tolerance", "evaluations", "final error"});
  for (const double tolerance : {1e-11, 1e-12, 1e-13, 1e-15, 1e-17}) {
    const auto s = integrate_adaptive<DormandPrince54>(SunsPull{}, mild.at(0), 0.0, mild.period(),
                                                       {tolerance, tolerance});
    const double error = (s.y - mild.at(mild.period())).head<2>().norm();
    table.add({number(tolerance), std::to_string(s.evaluations),
               error < 5e-13 ? "< 5e-13 AU" : error_number(error) + " AU"});
  }
  return table;
}

Table no_solution_table() {
  using Vec1 = Eigen::Matrix<double, 1, 1>;
  Table table({"h", "iterations", "y₁ found", "(1 − √(1 − 4h)) / (2h)"});
  for (const double h : {0.1, 0.2, 0.24, 0.2499, 0.26, 0.5}) {
    int iterations = 0;
    const auto square = [&](double, const Vec1& y) {
      ++iterations;
      return Vec1(y[0] * y[0]);
    };
    const auto dfdy = [](double, const Vec1& y) { return Vec1(2 * y[0]); };
    std::string found = "refused";
    try {
      found = number(
          runge_kutta::backward_euler_step(with_jacobian(square, dfdy), 0.0, Vec1(1.0), h)[0], 6);
    } catch (const std::runtime_error&) {
    }
    table.add({number(h, 4), std::to_string(iterations), found,
               h <= 0.25 ? number((1 - std::sqrt(1 - 4 * h)) / (2 * h), 6) : "no real number"});
  }
  return table;
}

Table rod_table() {
  constexpr double angle = pi / 3, seconds = 10;
  Table table({"stiffness", "DP 5(4), x and z", "Radau5, x and z", "Radau5, angle and stretch",
               "apart by"});
  for (const double k : {1e2, 1e4, 1e6, 1e8}) {
    const double stretch = gravity * std::cos(angle) / k, r = 1 + stretch;
    const Vec4 place(r * std::sin(angle), -r * std::cos(angle), 0, 0), polar(angle, stretch, 0, 0);
    const auto a = integrate_adaptive<DormandPrince54>(RodInXY{k}, place, 0.0, seconds);
    const auto b = integrate_adaptive<Radau5>(RodInXY{k}, place, 0.0, seconds);
    const auto c = integrate_adaptive<Radau5>(RodInAngle{k}, polar, 0.0, seconds);
    const Vec2 end = (1 + c.y[1]) * Vec2(std::sin(c.y[0]), -std::cos(c.y[0]));
    table.add({number(k) + " N/m", std::to_string(a.evaluations), std::to_string(b.evaluations),
               std::to_string(c.evaluations), error_number((a.y.head<2>() - end).norm()) + " m"});
  }
  return table;
}

Table unseen_table() {
  Table table({"method", "order", "problem", "steps", "order seen"});
  const auto add = [&](const std::string& method, int order, const std::string& problem,
                       const std::array<int, 3>& steps, auto&& error) {
    table.add({method, std::to_string(order), problem,
               std::to_string(steps.front()) + " to " + std::to_string(steps.back()),
               number(order_from(steps, error), 2)});
  };
  const auto orbit_error = []<class Method>(Method) {
    return [](int n) { return mild_error(mild_end<Method>(n)); };
  };
  add("Euler", 1, "mild orbit", {2048, 4096, 8192}, orbit_error(runge_kutta::Euler{}));
  add("Euler", 1, "mild orbit, long steps", {8, 16, 32}, orbit_error(runge_kutta::Euler{}));
  add("DP 5(4)", 5, "mild orbit", {48, 96, 192}, orbit_error(DormandPrince54{}));
  add("DP 5(4)", 5, "mild orbit, 7/10 of a revolution", {96, 192, 288}, [](int n) {
    const double t = 0.7 * mild.period();
    const Vec4 y = integrate_fixed<DormandPrince54>(SunsPull{}, mild.at(0), 0.0, t, n);
    return (y - mild.at(t)).norm();
  });
  for (const double stiffness : {1.0, 1000.0})
    add("Radau5", 5, "y' = −" + number(stiffness, 4) + " (y − cos t) − sin t", {16, 32, 64},
        [&](int n) { return driven_error(stiffness, n); });
  return table;
}

}  // namespace solvers_chapter
