/// @file
/// Work and precision: one problem, many methods, each at many steps or tolerances.

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "parts.hpp"
#include "problems.hpp"
#include "support/plot.hpp"
#include "support/stopwatch.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

using support::number;

namespace {

/// What all methods have to solve, and the place where it ends.
template <class F>
struct Race {
  F f;
  Vec4 start;
  double t1;
  Vec2 end;

  double error(const Vec4& y) const { return (y.head<2>() - end).norm(); }
};

/// One run: what it took and how far off it ended.
struct Sample {
  int evaluations;
  double error;
  std::function<void()> again;  ///< to be timed
};

struct Runner {
  std::string name;
  std::vector<Sample> samples;

  /// The cheapest run with at most this error, or nullptr.
  const Sample* reaching(double error) const {
    const Sample* best = nullptr;
    for (const Sample& s : samples)
      if (s.error <= error && (best == nullptr || s.evaluations < best->evaluations)) best = &s;
    return best;
  }
};

/// A run is counted and kept, unless the method refuses.
template <class F, class Solve>
void run(Runner& runner, const Race<F>& race, const Solve& solve) {
  int evaluations = 0;
  try {
    const Vec4 y = solve(runge_kutta::CountedRhs<const F>(race.f, evaluations));
    if (!y.allFinite()) return;
    runner.samples.push_back(
        {evaluations, race.error(y), [solve, f = race.f] { support::keep(solve(f)); }});
  } catch (const std::runtime_error&) {
    return;
  }
}

template <class Method, class F>
Runner fixed_steps(const std::string& name, const Race<F>& race, int fewest, int most) {
  Runner runner{name, {}};
  for (int steps = fewest; steps <= most; steps *= 2)
    run(runner, race, [start = race.start, t1 = race.t1, steps](const auto& f) {
      return integrate_fixed<Method>(f, start, 0.0, t1, steps);
    });
  return runner;
}

/// From a tolerance of 1e-2 to 10 to the power −digits, half a decade at a time.
template <class Method, class F>
Runner adaptive_steps(const std::string& name, const Race<F>& race, int digits) {
  Runner runner{name, {}};
  for (int half = 4; half <= 2 * digits; ++half) {
    const double tolerance = std::pow(10.0, -half / 2.0);
    run(runner, race, [start = race.start, t1 = race.t1, tolerance](const auto& f) {
      return integrate_adaptive<Method>(f, start, 0.0, t1, {tolerance, tolerance}).y;
    });
  }
  return runner;
}

template <class F>
std::vector<Runner> all_runners(const Race<F>& race) {
  return {fixed_steps<runge_kutta::Euler>("Euler", race, 128, 1 << 18),
          fixed_steps<runge_kutta::Midpoint>("midpoint", race, 128, 1 << 18),
          fixed_steps<Rk4>("RK4", race, 64, 1 << 18),
          adaptive_steps<DormandPrince54>("DP 5(4)", race, 13),
          adaptive_steps<Dop853>("DOP853", race, 13),
          fixed_steps<runge_kutta::BackwardEuler>("backward Euler", race, 64, 1 << 15),
          adaptive_steps<Radau5>("Radau5", race, 11)};
}

const std::vector<Runner>& comet_runners() {
  static const std::vector<Runner> runners = all_runners(
      Race<SunsPull>{{}, comet.at(0), comet.period(), comet.at(comet.period()).head<2>()});
  return runners;
}

/// The end is where the most exact method goes with the tightest tolerance.
const std::vector<Runner>& dust_runners() {
  static const std::vector<Runner> runners = [] {
    const Dust dust = dust_of_radius(3e-6);
    const Vec4 end =
        integrate_adaptive<Dop853>(dust, dust_start(), 0.0, dust_time, {1e-14, 1e-14}).y;
    return all_runners(Race<Dust>{dust, dust_start(), dust_time, end.head<2>()});
  }();
  return runners;
}

std::string work_figure(const std::string& title, const std::string& error,
                        const std::vector<Runner>& runners) {
  support::Plot plot{
      title, {"evaluations of dydt", support::Scale::log}, {error, support::Scale::log}, {}};
  for (const Runner& runner : runners) {
    support::Series series{runner.name, {}, {}};
    for (const Sample& s : runner.samples) {
      if (s.error > 100) continue;  // nowhere near
      series.x.push_back(s.evaluations);
      series.y.push_back(s.error);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

/// The least time [s] of each method's cheapest run for an error, or ∞; the methods take turns.
std::vector<double> times_to(const std::vector<Runner>& runners, double goal) {
  std::vector<double> times(runners.size(), std::numeric_limits<double>::infinity());
  for (int turn = 0; turn < 3; ++turn)
    for (std::size_t i = 0; i < runners.size(); ++i)
      if (const Sample* sample = runners[i].reaching(goal))
        times[i] = std::min(times[i], support::shortest_run(0.006, sample->again));
  return times;
}

}  // namespace

std::string comet_work_figure() {
  return work_figure("one revolution of the comet", "distance from the start [AU]",
                     comet_runners());
}

std::string dust_work_figure() {
  return work_figure("ten seconds of dust", "distance from the true end [m]", dust_runners());
}

Table reach_table() {
  Table table(
      {"method", "comet: 1e-3 AU", "1e-6 AU", "1e-9 AU", "dust: 1e-3 m", "1e-6 m", "1e-9 m"});
  for (std::size_t i = 0; i < comet_runners().size(); ++i) {
    std::vector<std::string> row{comet_runners()[i].name};
    for (const Runner* runner : {&comet_runners()[i], &dust_runners()[i]})
      for (const double goal : {1e-3, 1e-6, 1e-9}) {
        const Sample* sample = runner->reaching(goal);
        row.push_back(sample == nullptr ? "–" : std::to_string(sample->evaluations));
      }
    table.add(row);
  }
  return table;
}

Table times_table() {
  constexpr std::size_t dp54 = 3, radau5 = 6;
  Table table({"method", "comet, 1e-6", "of DP 5(4)", "comet, 1e-9", "of DP 5(4)", "dust, 1e-6",
               "of Radau5"});
  const std::vector<double> comet_6 = times_to(comet_runners(), 1e-6),
                            comet_9 = times_to(comet_runners(), 1e-9),
                            dust_6 = times_to(dust_runners(), 1e-6);
  for (std::size_t i = 0; i < comet_runners().size(); ++i) {
    std::vector<std::string> row{comet_runners()[i].name};
    const auto add = [&](double seconds, double reference) {
      const bool reached = std::isfinite(seconds);
      row.push_back(reached ? support::duration(seconds) : "–");
      row.push_back(reached ? ratio_number(seconds / reference) + " ×" : "–");
    };
    add(comet_6[i], comet_6[dp54]);
    add(comet_9[i], comet_9[dp54]);
    add(dust_6[i], dust_6[radau5]);
    table.add(row);
  }
  return table;
}

Table eccentricity_table() {
  Table table({"eccentricity", "closest : farthest", "equal steps", "adaptive", "ratio"});
  for (const double e : {0.0, 0.5, 0.9, 0.967, 0.99}) {
    const Orbit orbit{1, e};
    const Race<SunsPull> race{{}, orbit.at(0), orbit.period(), orbit.at(orbit.period()).head<2>()};
    Runner fixed{"", {}};
    for (int steps = 40; fixed.reaching(1e-6) == nullptr; steps += steps / 4)
      fixed = fixed_steps<DormandPrince54>("", race, steps, steps);
    const Runner adaptive = adaptive_steps<DormandPrince54>("", race, 11);
    const int alike = fixed.reaching(1e-6)->evaluations,
              needed = adaptive.reaching(1e-6)->evaluations;
    table.add({number(e), "1 : " + number((1 + e) / (1 - e)), std::to_string(alike),
               std::to_string(needed), ratio_number(static_cast<double>(alike) / needed)});
  }
  return table;
}

}  // namespace solvers_chapter
