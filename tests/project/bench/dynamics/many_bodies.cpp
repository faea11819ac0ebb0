#include "project/bench/dynamics/many_bodies.hpp"

#include <algorithm>
#include <iostream>
#include <limits>

#include "project/bench/dynamics/as_rigid_body.hpp"
#include "project/bench/dynamics/problems.hpp"
#include "project/bench/least_times.hpp"
#include "support/stopwatch.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::bench {
namespace {

constexpr int steps = 240;
constexpr double second = 1, h = second / steps;
constexpr double promised = 1e-7;  // [rad]: what all of ours come to, those of order 4 too

/// To 1e-12 rad or so.
Quat truth(const Body& body) {
  const auto end = integrate_adaptive<Dop853>(RigidBodyRhs(rigid_body(body)), pack(start_of(body)),
                                              0.0, second, {1e-13, 1e-13});
  return unpack<double>(end.y).q;
}

std::vector<Quat> truth(const Scene& scene) {
  std::vector<Quat> ends;
  for (const Body& body : scene.bodies) ends.push_back(truth(body));
  return ends;
}

double rms_error(const Simulation& simulation, const std::vector<Quat>& ends) {
  double sum = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double error = angle_between(simulation.spin(i).q.normalized(), ends[i]);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(ends.size()));
}

struct Result {
  const Stepper* stepper;
  std::shared_ptr<Simulation> simulation;
  double error = 0;    ///< root mean square [rad]
  double seconds = 0;  ///< of a step of all bodies
};

/// From the start to the end of the second; its time is not the one that is told, since much is
/// cold.
std::vector<Result> run_once(const Scene& scene, const std::vector<Stepper>& steppers) {
  const std::vector<Quat> ends = truth(scene);
  std::vector<Result> results;
  for (const Stepper& stepper : steppers) {
    std::cerr << "tumble: many: " << stepper.software << ' ' << stepper.name << '\n';
    Result result{&stepper, stepper.make(scene, h)};
    if (!result.simulation) continue;
    result.simulation->restart();
    result.seconds = support::shortest_run(0, [&] { result.simulation->advance(steps); }) / steps;
    result.error = rms_error(*result.simulation, ends);
    results.push_back(result);
  }
  return results;
}

int steps_within(const Budget& budget, const Result& result) {
  return std::clamp(static_cast<int>(budget.longest_run / result.seconds), 1, steps);
}

/// Further steps, as many as the budget allows of each.
void measure(std::vector<Result>& results, const Budget& budget) {
  std::cerr << "tumble: many: measuring\n";
  std::vector<Timed> all;
  for (const Result& result : results) {
    all.push_back({[&result, count = steps_within(budget, result)] {
                     result.simulation->advance(count);
                     return result.simulation->spin(0).q.w();
                   },
                   budget.repetitions, budget.seconds});
  }
  const std::vector<double> seconds = least_times(all);
  for (std::size_t i = 0; i < results.size(); ++i)
    results[i].seconds = seconds[i] / steps_within(budget, results[i]);
}

}  // namespace

ManyBodies many_bodies(int bodies, const std::vector<Stepper>& steppers, const Budget& budget) {
  std::vector<Result> results = run_once(crowd(bodies), steppers);
  measure(results, budget);
  double ours = std::numeric_limits<double>::infinity();
  for (const Result& result : results)
    if (result.stepper->software == "tumble") ours = std::min(ours, result.seconds);
  ManyBodies all{support::Table({"method", "ns per body and step", "× our fastest", "rms error"}),
                 {}};
  for (const Result& result : results) {
    all.table.add({result.stepper->software + ", " + result.stepper->name,
                   support::number(result.seconds * 1e9 / bodies, 3),
                   support::number(result.seconds / ours, 3), support::error_number(result.error)});
    if (result.stepper->software == "tumble" && !(result.error <= promised))
      all.broken += "; " + result.stepper->name;
  }
  return all;
}

}  // namespace tumble::bench
