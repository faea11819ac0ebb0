#include <optional>

#include "judge/mine/library_runs.hpp"
#include "support/stopwatch.hpp"
#include "tumble/simulate/simulate.hpp"

namespace tumble::judge::mine {

namespace {

Trajectory simulated(const Problem& problem, double tolerance) {
  const SimulationTask task{0, problem.duration, tolerance, Wanted::trajectory};
  if (!problem.pull) return simulate(problem.body, problem.start, task);
  return simulate(problem.body, problem.start, task, Weight{problem.pull->gravity},
                  problem.pull->spring);
}

}  // namespace

Point by_simulate(const Problem& problem, double tolerance) {
  const Trajectory trajectory = simulated(problem, tolerance);
  const SimulationReport& report = trajectory.report();
  return {report.steps, report.evaluations,
          support::shortest_run(0.01, [&] { support::keep(simulated(problem, tolerance).end()); }),
          problem.error(pack(trajectory.end()))};
}

}  // namespace tumble::judge::mine
