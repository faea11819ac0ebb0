#pragma once

#include "tumble/simulate/steady_trajectory.hpp"

#include "tumble/simulate/closed_trajectories.hpp"
#include "tumble/simulate/turning_trajectory.hpp"
#include "tumble/steady/lagrange_top.hpp"
#include "tumble/steady/steady_path.hpp"

namespace tumble::detail {

template <std::same_as<SteadyForces> Forces>
Trajectory steady_trajectory(const RigidBody<>& body, const RigidBodyState<>& start,
                             const Forces& forces, const SimulationTask& task) {
  const steady::SteadyPath path(body, start, forces);
  if (task.wanted == Wanted::path_only) return particle_trajectory(start, path, task);
  const steady::SteadyTorque torque(body, forces);
  if (torque.is_free() || torque.is_idle(torque.turning(start.q, start.L)))
    return free_trajectory(body, torque.axes(), start, path, task);
  if (const auto top = steady::LagrangeTop::from(torque, start.q, start.L))
    if (top->error_bound(task.t1 - task.t0) <= task.tolerance)
      return top_trajectory(*top, body, torque.axes(), start, path, task);
  const steady::SteadyTorque own = torque_for_series(body, forces, torque);
  switch (own.rank()) {
    case 0:
      return turning_trajectory<0>(own, path, body, start, task);
    case 1:
      return turning_trajectory<1>(own, path, body, start, task);
    case 2:
      return turning_trajectory<2>(own, path, body, start, task);
    default:
      return turning_trajectory<3>(own, path, body, start, task);
  }
}

#ifdef TUMBLE_COMPILED
template Trajectory steady_trajectory(const RigidBody<>&, const RigidBodyState<>&,
                                      const SteadyForces&, const SimulationTask&);
#endif

}  // namespace tumble::detail
