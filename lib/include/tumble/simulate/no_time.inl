#pragma once

#include "tumble/simulate/no_time.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/simulate/closed_trajectories.hpp"

namespace tumble::detail {

TUMBLE_BODY Trajectory no_time_trajectory(const RigidBody<>& body, const RigidBodyState<>& start,
                                          const SimulationTask& task) {
  return closed_trajectory(NoTurning{{start.q.normalized(), start.L}},
                           steady::SteadyPath(body, start, {}), 0, task,
                           {.method = "none: t1 is t0",
                            .why = "there is no time to move",
                            .tolerance = task.tolerance,
                            .error_estimate = 1e-15});
}

}  // namespace tumble::detail
