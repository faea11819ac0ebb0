#pragma once

#include "tumble/simulate/closed_trajectories.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/simulate/motion_tolerance.hpp"

namespace tumble::detail {

TUMBLE_BODY double lost_by_turning(const FreeRotation& rotation, double lost, double radians,
                                   double span) {
  constexpr double everything = 4;
  const auto* top = std::get_if<FreeAsymmetricTop>(&rotation);
  const double by_axes = top && lost > 0 ? top->error_by_axes(lost, span) : 0;
  return lost * radians + std::min(everything, by_axes);
}

TUMBLE_BODY Trajectory free_trajectory(const RigidBody<>& body, const PrincipalAxes& axes,
                                       const RigidBodyState<>& start,
                                       const steady::SteadyPath& path, const SimulationTask& task) {
  const FreeTurning turning{FreeFlow(axes).from(start.q, start.L), start.L};
  const double span = task.t1 - task.t0;
  const double omega = derived(body, start).omega.norm(), radians = omega * span;
  const ModelChoice choice = model_of_moments(axes);
  const double lost = rounding_of_moments(body.I_body(), axes.moments[0]);
  return closed_trajectory(
      turning, path, omega, task,
      {.model = choice.model,
       .method = turning.name(),
       .why = "no torque; " + choice.why,
       .tolerance = task.tolerance,
       .error_estimate = 1e-14 * std::max(1.0, radians) +
                         lost_by_turning(turning.rotation, lost, radians, span)});
}

TUMBLE_BODY Trajectory particle_trajectory(const RigidBodyState<>& start,
                                           const steady::SteadyPath& path,
                                           const SimulationTask& task) {
  return closed_trajectory(
      NoTurning{{start.q.normalized(), start.L}}, path, 0, task,
      {.model = Model::particle,
       .method = "closed form: path under steady forces",
       .why = "you don't ask for the orientation, and the path does not depend on it",
       .tolerance = task.tolerance,
       .error_estimate = 1e-15});
}

TUMBLE_BODY Trajectory top_trajectory(const steady::LagrangeTop& top, const RigidBody<>& body,
                                      const PrincipalAxes& axes, const RigidBodyState<>& start,
                                      const steady::SteadyPath& path, const SimulationTask& task) {
  const double omega = derived(body, start).omega.norm() + top.rate();
  const double lost = rounding_of_moments(body.I_body(), axes.moments[0]);
  const double span = task.t1 - task.t0;
  return closed_trajectory(
      top, path, omega, task,
      {.model = Model::symmetric_top,
       .method = "closed form: Lagrange top (elliptic functions)",
       .why = "two principal moments are equal, and the force acts on the axis",
       .tolerance = task.tolerance,
       .error_estimate = top.error_bound(span) + lost * omega * span});
}

}  // namespace tumble::detail
