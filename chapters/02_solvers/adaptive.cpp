/// @file
/// A comet: how we estimate the error of a step, and steps that suit the motion.

#include <cmath>

#include "drawing.hpp"
#include "parts.hpp"
#include "problems.hpp"
#include "support/plot.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

using support::error_number;
using support::number;

// ── A comet ──

namespace {

constexpr double days = 365.25;  // in a year
constexpr Tolerances comet_tolerances{1e-6, 1e-6};
const double period = comet.period();

/// One revolution of the comet.
OdeSolution<Vec4> one_round(const Tolerances& tolerances, Track& track) {
  const SunsPull f;
  const Vec4 y0 = comet.at(0);
  return integrate_adaptive<DormandPrince54>(f, y0, 0.0, period, tolerances, track);
}

Path ellipse(const Orbit& orbit) {
  Path path;
  for (int i = 0; i <= 240; ++i) {
    const double E = 2 * pi * i / 240;
    path.emplace_back(orbit.a * (std::cos(E) - orbit.e),
                      orbit.a * std::sqrt(1 - orbit.e * orbit.e) * std::sin(E));
  }
  return path;
}

}  // namespace

Table comet_table() {
  Table table({"steps", "how many", "evaluations", "shortest", "longest", "final error"});
  const auto add = [&](const std::string& name, const Track& track, int evaluations) {
    const double error = (track.places.back() - comet.at(period).head<2>()).norm();
    table.add({name, std::to_string(track.steps.size()), std::to_string(evaluations),
               number(days * track.shortest(), 4) + " d", number(days * track.longest(), 4) + " d",
               error_number(error) + " AU"});
  };
  Track adaptive;
  const OdeSolution<Vec4> solution = one_round(comet_tolerances, adaptive);
  const int as_many = solution.evaluations / 4;
  for (const int steps : {as_many, 10 * as_many, 100 * as_many}) {
    Track fixed;
    integrate_fixed<Rk4>(SunsPull{}, comet.at(0), 0.0, period, steps, fixed);
    add("RK4, equal steps", fixed, 4 * steps);
  }
  add("DP 5(4), adaptive", adaptive, solution.evaluations);
  return table;
}

std::string comet_figure() {
  Track fixed, adaptive;
  const int steps = one_round(comet_tolerances, adaptive).evaluations / 4;
  integrate_fixed<Rk4>(SunsPull{}, comet.at(0), 0.0, period, steps, fixed);

  support::Sketch sketch(760, 424, "one revolution of a comet, twice");
  const auto draw = [&](double top, const Track& track, const std::string& colour,
                        const std::string& words) {
    const Cutout cutout{{-36, -5}, {5, 5}, 10, top, 18};
    look_at(sketch, cutout);
    sketch.curve(ellipse(comet), {"faint", 1});
    Path from_start{comet.at(0).head<2>()};
    from_start.insert(from_start.end(), track.places.begin(), track.places.end());
    sketch.curve(cutout.within(from_start), {colour, 1, 0.6});
    sketch.dots(cutout.within(from_start), colour, 2.2);
    sketch.dot({0, 0}, "c4", 5);
    sketch.words({-17, -0.3}, {0, 0}, words, "ink", "middle");
  };
  draw(14, fixed, "c0", "RK4, " + std::to_string(steps) + " steps of the same length");
  draw(228, adaptive, "c3",
       "Dormand–Prince 5(4), " + std::to_string(adaptive.steps.size()) + " steps as needed");
  return sketch.svg();
}

// ── The error of a step ──

Table norm_table() {
  const Vec4 y(7e6, 7500, 0.001, 0), error(2, -1e-3, 2e-9, 1.5e-9);
  const Tolerances tolerances{1e-6, 1e-9};
  const std::vector<std::string> names{"distance from the Earth's centre", "speed", "turning rate",
                                       "angle to the sun"},
      units{" m", " m/s", " rad/s", " rad"};
  Table table({"component", "size", "error", "allowed", "ratio"});
  for (Eigen::Index i = 0; i < 4; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const double allowed = tolerances.absolute + tolerances.relative * std::abs(y[i]);
    table.add({names[n], number(y[i]) + units[n], number(error[i]) + units[n],
               number(allowed) + units[n], number(error[i] / allowed)});
  }
  table.add({"norm", "", "", "", number(runge_kutta::error_norm(error, y, y, tolerances))});
  return table;
}

Table estimate_table() {
  constexpr double t = 20;
  const Vec4 y = comet.at(t), dydt = SunsPull{}(t, y);
  Table table(
      {"step", "estimate: midpoint − Euler", "Euler", "midpoint", "DP 5(4)'s estimate", "DP 5(4)"});
  for (const double h : {4.0, 2.0, 1.0, 0.5}) {
    const Vec4 exact = comet.at(t + h);
    const auto size = [&](const Vec4& e) {
      return runge_kutta::error_norm(e, y, exact, comet_tolerances);
    };
    const Vec4 euler = runge_kutta::euler_step(SunsPull{}, t, y, h),
               midpoint = runge_kutta::midpoint_step(SunsPull{}, t, y, h);
    const auto attempt =
        DormandPrince54::Stepper<Vec4>(comet_tolerances, dydt).attempt(SunsPull{}, t, y, h);
    table.add({number(h) + " a", error_number(size(midpoint - euler)),
               error_number(size(euler - exact)), error_number(size(midpoint - exact)),
               error_number(attempt.error), error_number(size(attempt.y - exact))});
  }
  return table;
}

// ── Adaptive steps ──

std::string steps_figure() {
  support::Plot plot{"steps of the comet's solver",
                     {"time since the farthest point [a]"},
                     {"length of the step [d]", support::Scale::log},
                     {}};
  support::Series circle{"a revolution here", {}, {}};
  for (int i = 0; i <= 600; ++i) {
    const double t = period * i / 600, r = comet.at(t).head<2>().norm();
    circle.x.push_back(t);
    circle.y.push_back(days * r * std::sqrt(r));
  }
  plot.series.push_back(circle);
  for (const double tolerance : {1e-6, 1e-9}) {
    Track track;
    one_round({tolerance, tolerance}, track);

    support::Series series{
        "tolerance " + support::power_of_ten(static_cast<int>(std::lround(std::log10(tolerance)))),
        {},
        {}};
    for (std::size_t i = 0; i < track.steps.size(); ++i) {
      series.x.push_back(track.times[i] - track.steps[i] / 2);
      series.y.push_back(days * track.steps[i]);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

Table tolerance_table() {
  Table table({"method", "tolerance", "kept", "rejected", "evaluations", "final error",
               "error / tolerance"});
  const auto add = [&]<class Method>(const std::string& name, Method) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
      const auto s =
          integrate_adaptive<Method>(SunsPull{}, comet.at(0), 0.0, period, {tolerance, tolerance});
      const double error = (s.y - comet.at(period)).template head<2>().norm();
      table.add({name, number(tolerance), std::to_string(s.steps), std::to_string(s.rejected),
                 std::to_string(s.evaluations), error_number(error) + " AU",
                 ratio_number(error / tolerance)});
    }
  };
  add("DP 5(4)", DormandPrince54{});
  add("DOP853", Dop853{});
  return table;
}

}  // namespace solvers_chapter
