#include "project/bench/speed_against_error.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include "project/bench/least_times.hpp"
#include "support/stopwatch.hpp"
#include "tumble/core/require.hpp"

namespace tumble::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A setting that has been tried once.
struct Trial {
  std::size_t curve;
  double setting;
  Attempt attempt;
  double error, seconds;
};

Trial try_once(double setting, const Attempt& attempt) {
  Trial trial{0, setting, attempt, infinity, infinity};
  try {
    double error = infinity;
    trial.seconds = support::shortest_run(0, [&] { error = attempt.error(); });
    if (!std::isnan(error)) trial.error = error;
  } catch (const std::exception&) {  // a solver that gives up: no finer setting will do
  }
  return trial;
}

/// A decade of tolerance, or twice the steps; where runs are short, in four parts.
double finer(Knob knob, double setting, bool is_long) {
  const double parts = is_long ? 1 : 4;
  if (knob == Knob::tolerance) return setting / std::pow(10, 1 / parts);
  return std::ceil(setting * std::pow(2, 1 / parts));
}

bool worth_trying(Knob knob, double setting) {
  return knob == Knob::tolerance ? setting > 1e-15 : setting < 1e9;
}

/// From coarse to fine, as long as the time allows; only what is better than all before is kept.
std::vector<Trial> sweep(const Entrant& entrant, double longest_run) {
  std::vector<Trial> kept;
  double best = infinity, before = 0;
  bool is_long = false;
  for (double setting = entrant.coarsest; worth_trying(entrant.knob, setting);
       setting = finer(entrant.knob, setting, is_long)) {
    const Attempt attempt = entrant.prepare(setting);
    Trial trial = try_once(setting, attempt);
    // A jump: perhaps something else ran, which must not end the sweep.
    if (trial.seconds > 3 * before) trial.seconds = try_once(setting, attempt).seconds;
    before = trial.seconds;
    if (trial.error < best) kept.push_back(trial);
    best = std::min(best, trial.error);
    is_long = trial.seconds > longest_run / 16;
    if (trial.seconds > longest_run / 2) break;
  }
  return kept;
}

Timed timed(const Trial& trial, const Budget& budget) {
  const double affordable = std::max(1.0, budget.longest_run / 2 / trial.seconds);
  const int repetitions = static_cast<int>(std::min<double>(budget.repetitions, affordable));
  return {trial.attempt.run, repetitions, budget.seconds, Clock::thread};
}

}  // namespace

double Curve::best_error() const { return points.empty() ? infinity : points.back().error; }

double Curve::seconds_to_reach(double error) const {
  double least = infinity;
  for (const Point& point : points)
    if (point.error <= error) least = std::min(least, point.seconds);
  return least;
}

std::vector<Curve> speed_against_error(const std::string& problem,
                                       const std::vector<Entrant>& entrants, const Budget& budget) {
  std::vector<Curve> curves;
  std::vector<Trial> trials;
  for (const Entrant& entrant : entrants) {
    curves.push_back({entrant.software, entrant.name, entrant.knob, entrant.promised});
    std::cerr << "tumble: " << problem << ": " << curves.back().full_name() << '\n';
    const bool ours = curves.back().is_ours();
    for (Trial trial : sweep(entrant, ours ? budget.longest_run : budget.longest_of_others)) {
      trial.curve = curves.size() - 1;
      trials.push_back(trial);
    }
  }
  std::cerr << "tumble: " << problem << ": measuring\n";
  std::vector<Timed> all;
  for (const Trial& trial : trials) all.push_back(timed(trial, budget));
  const std::vector<double> seconds = least_times(all);
  for (std::size_t i = 0; i < trials.size(); ++i)
    curves[trials[i].curve].points.push_back({trials[i].setting, trials[i].error, seconds[i]});
  return curves;
}

void check_promises(const std::string& problem, const std::string& quantity,
                    const std::vector<Curve>& curves) {
  std::string broken;
  for (const Curve& curve : curves)
    if (curve.best_error() > curve.promised) {
      std::ostringstream text;
      text << "; " << quantity << ": " << curve.name << " comes to " << curve.best_error()
           << ", but promises " << curve.promised;
      broken += text.str();
    }
  require(broken.empty(), problem, broken);
}

}  // namespace tumble::bench
