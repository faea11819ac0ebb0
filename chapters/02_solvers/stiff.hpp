#pragma once
/// @file
/// Where each method is stable, problems in which that decides, and the step that does not care.

#include <cmath>
#include <complex>

#include "drawing.hpp"
#include "problems.hpp"
#include "support/plot.hpp"
#include "support/table.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

using support::error_number;
using support::number;
using support::Table;

// ── Stability ──

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

inline Table stability_table() {
  Table table({"method", "evaluations a step", "stable from 0 to −…", "to ±… i", "|R(−1000)|"});
  const auto add = [&]<class Method>(const std::string& name, const std::string& cost, Method) {
    table.add({name, cost, stable_length<Method>(-1), stable_length<Method>(Complex(0, 1)),
               error_number(std::abs(stability_function<Method>(-1000)))});
  };
  add("Euler", "1", Euler{});
  add("midpoint", "2", Midpoint{});
  add("RK4", "4", Rk4{});
  add("DP 5(4)", "6", DormandPrince54{});
  add("DOP853", "12", Dop853{});
  add("backward Euler", "a few, and ∂f/∂y", BackwardEuler{});
  add("Radau5", "some ten, and ∂f/∂y", Radau5{});
  return table;
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

inline std::string regions_figure() {
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
  add(stability_boundary<Rk4>(), "c2", "RK4", {-0.6, 2.2});
  add(stability_boundary<Midpoint>(), "c1", "midpoint", {-1, 1.06});
  add(stability_boundary<Euler>(), "c0", "Euler", {-1, 0.3});
  add(stability_boundary<BackwardEuler>(), "c6", "backward Euler: stable outside", {5, 0.9});
  sketch.words({7.9, -0.42}, {0, 0}, "Re z", "ink", "end");
  sketch.words({0.12, 6.15}, {0, 0}, "Im z");
  return sketch.svg();
}

// ── Stiff problems ──

constexpr Tolerances dust_tolerances{1e-6, 1e-6};

inline const std::vector<double> radii{100e-6, 30e-6, 10e-6, 3e-6, 1e-6};

inline std::string micrometres(double radius) { return number(1e6 * radius) + " µm"; }

template <class Method>
OdeSolution<Vec4> fly(double radius, const Tolerances& tolerances = dust_tolerances) {
  return integrate_adaptive<Method>(dust_of_radius(radius), dust_start(), 0.0, dust_time,
                                    tolerances);
}

inline Table dust_table() {
  const auto steps = [](const OdeSolution<Vec4>& s) {
    return std::to_string(s.steps) + " + " + std::to_string(s.rejected);
  };
  Table table({"radius", "τ", "10 s / (3.3 τ)", "DP 5(4) steps", "Radau5 steps", "apart by"});
  for (const double radius : radii) {
    const auto explicit_one = fly<DormandPrince54>(radius);
    const auto implicit_one = fly<Radau5>(radius);
    const double tau = dust_of_radius(radius).tau;
    table.add({micrometres(radius), number(1000 * tau) + " ms",
               std::to_string(std::lround(dust_time / (3.3 * tau))), steps(explicit_one),
               steps(implicit_one),

               error_number((explicit_one.y - implicit_one.y).head<2>().norm()) + " m"});
  }
  return table;
}

/// The same speck at other tolerances.
inline Table indifferent_table() {
  Table table({"tolerance", "DP 5(4): kept", "rejected", "evaluations", "Radau5: kept", "rejected",
               "evaluations"});
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const auto explicit_one = fly<DormandPrince54>(1e-6, {tolerance, tolerance});
    const auto implicit_one = fly<Radau5>(1e-6, {tolerance, tolerance});
    table.add({number(tolerance), std::to_string(explicit_one.steps),
               std::to_string(explicit_one.rejected), std::to_string(explicit_one.evaluations),
               std::to_string(implicit_one.steps), std::to_string(implicit_one.rejected),
               std::to_string(implicit_one.evaluations)});
  }
  return table;
}

/// Where the air itself goes.
inline Path streamline(const Vec2& from, double seconds) {
  Path path{from};
  integrate_fixed<Rk4>([](double, const Vec2& x) -> Vec2 { return wind(x); }, from, 0.0, seconds,
                       static_cast<int>(10 * seconds),
                       [&](double, const Vec2& x) { path.push_back(x); });
  return path;
}

inline std::string dust_figure() {
  support::Sketch sketch(760, 452, "specks of dust in the wind");
  look_at(sketch, {{-1.03, -0.02}, {2.03, 2.02}, 10, 10, 210});
  for (const double x : {-0.5, 0.5, 1.5})
    for (const double y : {0.5, 1.5})
      for (const double r : {0.1, 0.2, 0.3, 0.4, 0.47})
        sketch.curve(streamline({x, y - r}, r < 0.45 ? 5 + 5 * r : 11), {"grid", 1.2});
  const std::vector<std::pair<double, std::string>> specks{
      {100e-6, "c1"}, {30e-6, "c3"}, {10e-6, "c2"}, {1e-6, "c0"}};
  double row = 50;  // of the names, right of the drawing [px]
  for (const auto& [radius, colour] : specks) {
    Track track;
    const auto solution = integrate_adaptive<Radau5>(dust_of_radius(radius), dust_start(), 0.0,
                                                     dust_time, dust_tolerances, track);
    sketch.curve(track.places, {colour, 1.6});
    sketch.dots(track.places, colour, 2.2);
    const Vec2 corner(2.03, 2.02);
    sketch.words(corner, {10, row}, micrometres(radius), colour);
    sketch.words(corner, {10, row + 21}, std::to_string(solution.steps) + " steps", colour);
    row += 60;
  }
  return sketch.svg();
}

inline std::string stiffness_figure() {
  support::Plot plot{"ten seconds of dust",
                     {"1/τ [1/s]", support::Scale::log},
                     {"evaluations of dydt", support::Scale::log},
                     {}};
  support::Series dp54{"DP 5(4)", {}, {}}, dop853{"DOP853", {}, {}}, radau{"Radau5", {}, {}};
  for (double radius = 100e-6; radius > 0.99e-6; radius /= std::sqrt(std::sqrt(10.0))) {
    for (support::Series* series : {&dp54, &dop853, &radau})
      series->x.push_back(1 / dust_of_radius(radius).tau);
    dp54.y.push_back(fly<DormandPrince54>(radius).evaluations);
    dop853.y.push_back(fly<Dop853>(radius).evaluations);
    radau.y.push_back(fly<Radau5>(radius).evaluations);
  }
  plot.series = {dp54, dop853, radau};
  return support::to_svg(plot);
}

// ── An oscillator that is stiff now and then ──

constexpr VanDerPol oscillator{100};
constexpr double oscillator_time = 200;
constexpr Tolerances oscillator_tolerances{1e-5, 1e-5};

/// (time, step, state at its end) of each step.
struct Step {
  double t, h;
  Vec2 y;
};

template <class Method>
std::vector<Step> oscillator_steps() {
  std::vector<Step> steps;
  double last = 0;
  integrate_adaptive<Method>(oscillator, Vec2(2, 0), 0.0, oscillator_time, oscillator_tolerances,
                             [&](double t, const Vec2& y) {
                               steps.push_back({t, t - last, y});
                               last = t;
                             });
  return steps;
}

inline std::string relaxation_figure() {
  const std::vector<Step> steps = oscillator_steps<Radau5>();
  support::Plot plot{"an oscillator that waits and jumps", {"time"}, {"y"}, {}};
  support::Series dense{"y", {0}, {2}};
  integrate_adaptive<Radau5>(
      oscillator, Vec2(2, 0), 0.0, oscillator_time, {1e-8, 1e-8}, [&](double t, const Vec2& y) {
        const bool near = std::hypot(t - dense.x.back(), 30 * (y[0] - dense.y.back())) < 1;
        if (near && t < oscillator_time) return;
        dense.x.push_back(t);
        dense.y.push_back(y[0]);
      });
  support::Series dots{"steps of Radau5", {}, {}, support::Look::dots};
  for (const Step& step : steps) {
    dots.x.push_back(step.t);
    dots.y.push_back(step.y[0]);
  }
  plot.series = {dense, dots};
  return support::to_svg(plot);
}

inline std::string ridden_figure() {
  support::Plot plot{
      "two solvers of the oscillator", {"time"}, {"length of the step", support::Scale::log}, {}};
  support::Series limit{"3.3 / |λ|", {}, {}}, dp54{"DP 5(4)", {}, {}}, radau{"Radau5", {}, {}};
  for (const Step& step : oscillator_steps<Radau5>()) {
    radau.x.push_back(step.t - step.h / 2);
    radau.y.push_back(step.h);
  }
  const std::vector<Step> steps = oscillator_steps<DormandPrince54>();
  const std::size_t every = steps.size() / 400;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const bool jumps = std::abs(steps[i].y[1]) > 2;
    if (i % (jumps ? 4 : every) != 0) continue;
    const double decay = -oscillator.fastest_decay(steps[i].y);
    dp54.x.push_back(steps[i].t);
    dp54.y.push_back(steps[i].h);
    limit.x.push_back(steps[i].t);
    limit.y.push_back(decay > 0 ? 3.3 / decay : -1);
  }
  plot.series = {dp54, limit, radau};
  return support::to_svg(plot);
}

// ── Implicit steps ──

/// The rounds in which the equation of a backward Euler step is solved, or not.
inline Table newton_table() {
  const Dust dust = dust_of_radius(3e-6);
  const Vec4 y = fly<Radau5>(3e-6).y;
  constexpr double h = 0.1;
  std::vector<Vec4> rounds;
  const auto watched = [&](double t, const Vec4& z) {
    rounds.push_back(z);
    return dust(t, z);
  };
  const auto dfdy = [&](double t, const Vec4& z) { return jacobian(dust, t, z, dust(t, z), h); };
  const Vec4 y1 = backward_euler_step(with_jacobian(watched, dfdy), 0.0, y, h);

  Table table({"round", "put back in again", "Newton's method"});
  Vec4 z = y;
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    table.add({std::to_string(i), error_number((z - y1).norm()),
               error_or_rounding((rounds[i] - y1).norm())});
    z = y + h * dust(h, z);
  }
  return table;
}

}  // namespace solvers_chapter
