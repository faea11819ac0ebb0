#pragma once
/// @file
/// A trajectory that owns the run that it came from.

#include <memory>
#include <utility>
#include <vector>

#include "tumble/simulate/no_end.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// What a run gives at one time: a state, or one of each body.
template <class Run>
using StateOf = decltype(std::declval<const Run&>().at(0.0));

/// What a run gives, for a Trajectory.
template <class Run>
class ComputedTrajectory final : public AnyTrajectory<StateOf<Run>> {
 public:
  ComputedTrajectory(Run run, double t1) : run_(std::move(run)), t1_(t1) {}

  StateOf<Run> at(double t) const override { return run_.at(t); }
  std::vector<double> times() const override { return run_.times(t1_); }

 private:
  Run run_;
  double t1_;
};

/// A trajectory that owns its run.
/// @throws std::runtime_error if the motion has left the range of doubles on the way
template <class Run>
TrajectoryOf<StateOf<std::decay_t<Run>>> trajectory_of(Run&& run, const SimulationTask& task,
                                                       const SimulationReport& report) {
  require_finite(run.at(task.t1), report.error_estimate, task.t1);
  using Motion = ComputedTrajectory<std::decay_t<Run>>;
  return {std::make_shared<const Motion>(std::forward<Run>(run), task.t1), task.t0, task.t1,
          report};
}

}  // namespace tumble::detail
