#include "project/bench/dynamics/work_precision.hpp"

#include <algorithm>
#include <iostream>

#include "project/bench/least_times.hpp"
#include "support/stopwatch.hpp"
#include "tumble/core/require.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double eps = std::numeric_limits<double>::epsilon();

/// A setting that has been tried once.
struct Trial {
  std::size_t curve;
  Run run;
  double error, seconds;
};

double error_of(const Quat& q, const Problem& problem) {
  const double error = angle_between(q.normalized(), problem.end);
  return std::isnan(error) ? infinity : error;
}

Trial try_once(const Problem& problem, const Run& run) {
  Trial trial{0, run, infinity, infinity};
  try {
    Quat q;
    trial.seconds = support::shortest_run(0, [&] { q = run(); });
    trial.error = error_of(q, problem);
  } catch (const std::exception&) {  // a solver that gives up: no finer setting will do
  }
  return trial;
}

double coarsest(Knob knob, const Problem& problem) {
  if (knob == Knob::tolerance) return 1e-2;
  return std::ceil(problem.duration * problem.body().start.omega.norm());  // a radian a step
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
std::vector<Trial> sweep(const Problem& problem, const Method& method, double longest_run) {
  std::vector<Trial> kept;
  double best = infinity, before = 0;
  bool is_long = false;
  for (double setting = coarsest(method.knob, problem); worth_trying(method.knob, setting);
       setting = finer(method.knob, setting, is_long)) {
    const Run run = method.prepare(problem, setting);
    Trial trial = try_once(problem, run);
    // A jump: perhaps something else ran, which must not end the sweep.
    if (trial.seconds > 3 * before) trial.seconds = try_once(problem, run).seconds;
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
  return {[run = trial.run] { return run().w(); }, repetitions, budget.seconds};
}

}  // namespace

double Curve::best_error() const { return points.empty() ? infinity : points.back().error; }

double Curve::seconds_to_reach(double error) const {
  double least = infinity;
  for (const Point& point : points)
    if (point.error <= error) least = std::min(least, point.seconds);
  return least;
}

Method as_method(const Stepper& stepper) {
  const auto prepare = [make = stepper.make](const Problem& problem, double steps) -> Run {
    const std::shared_ptr<Simulation> simulation = make(problem.scene, problem.duration / steps);
    if (!simulation) return {};
    return [simulation, count = static_cast<int>(steps)] {
      simulation->restart();
      simulation->advance(count);
      return simulation->spin(0).q;
    };
  };
  return {stepper.software, stepper.name, Knob::steps, prepare, stepper.roundings};
}

std::vector<Curve> work_precision(const Problem& problem, const std::vector<Method>& methods,
                                  const Budget& budget) {
  std::vector<Curve> curves;
  std::vector<Trial> trials;
  for (const Method& method : methods) {
    if (!method.prepare(problem, coarsest(method.knob, problem))) continue;
    std::cerr << "tumble: " << problem.name << ": " << method.software << ' ' << method.name
              << '\n';
    const bool ours = method.software == "tumble";
    for (Trial trial :
         sweep(problem, method, ours ? budget.longest_run : budget.longest_of_others)) {
      trial.curve = curves.size();
      trials.push_back(trial);
    }
    curves.push_back({&method});
  }
  std::cerr << "tumble: " << problem.name << ": measuring\n";
  std::vector<Timed> all;
  for (const Trial& trial : trials) all.push_back(timed(trial, budget));
  const std::vector<double> seconds = least_times(all);
  for (std::size_t i = 0; i < trials.size(); ++i)
    curves[trials[i].curve].points.push_back({trials[i].error, seconds[i]});
  return curves;
}

void check_promises(const Problem& problem, const std::vector<Curve>& curves) {
  std::string broken;
  for (const Curve& curve : curves) {
    const double promised = curve.method->roundings * problem.condition * eps;
    if (curve.best_error() > promised) {
      std::ostringstream text;
      text << "; " << curve.method->name << " comes to " << curve.best_error()
           << " rad, but promises " << promised;
      broken += text.str();
    }
  }
  require(broken.empty(), problem.name, broken);
}

}  // namespace tumble::bench
