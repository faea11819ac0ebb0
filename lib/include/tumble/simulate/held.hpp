#pragma once
/// @file
/// Says how a body turns that is held at one of its points, as simulate() does for one that is
/// free.

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "tumble/body/held_body.hpp"
#include "tumble/simulate/held_error.hpp"
#include "tumble/simulate/simulate.hpp"
#include "tumble/simulate/valid_start.hpp"

namespace tumble {

/// @addtogroup simulate
/// @{

namespace detail {

/// The motion of the held body, from its turning about the point.
class HeldTrajectory final : public AnyTrajectory<RigidBodyState<>> {
 public:
  HeldTrajectory(const HeldBody& held, Trajectory turning)
      : held_(held), turning_(std::move(turning)) {}

  RigidBodyState<> at(double t) const override { return held_.state_of(turning_.at(t)); }
  std::vector<double> times() const override { return turning_.times(); }

 private:
  HeldBody held_;
  Trajectory turning_;
};

/// The motion of a held body, by finer turnings until the centre's error is what was asked for.
/// @param turn      turn(tolerance) → the turning
/// @param tolerance that was asked for
template <class Turn>
Trajectory held_trajectory(const HeldBody& held, const Turn& turn, double tolerance) {
  constexpr double finer = 0.01, finest = 1e-15;
  Trajectory turning = turn(tolerance);
  HeldError error(held, turning);
  SimulationReport report = error.report(tolerance), costs = report;
  for (double asked = tolerance;
       !report.reached() && turning.report().reached() && asked > finest;) {
    asked = std::max(finest, finer * asked);
    const Trajectory next = turn(asked);
    const HeldError next_error(held, next);
    const SimulationReport next_report = next_error.report(tolerance, error);
    add_report(costs, next_report);
    if (!(next_report.error_estimate < report.error_estimate)) break;
    turning = next;
    error = next_error;
    report = next_report;
  }
  report.runs = costs.runs;
  report.steps = costs.steps;
  report.rejected = costs.rejected;
  report.evaluations = costs.evaluations;
  return {std::make_shared<const HeldTrajectory>(held, turning), turning.t0(), turning.t1(),
          report};
}

/// The motion of a held body from its turning about the point.
/// @param from as HeldBody::turning() gives it
template <BodyForce<double>... Forces>
Trajectory simulate_turning(const HeldBody& held, const RigidBodyState<>& from, SimulationTask task,
                            const Forces&... forces) {
  (require_valid_force(forces), ...);
  task.wanted = Wanted::trajectory;  // the path of the centre follows from the turning
  const auto turned_by = [&](const auto&... torques) {
    const auto turn = [&](double tolerance) {
      SimulationTask finer = task;
      finer.tolerance = tolerance;
      return simulate(held.about_point(), from, finer, torques...);
    };
    return held_trajectory(held, turn, task.tolerance);
  };
  if constexpr ((SteadyForce<Forces> && ...)) {
    const SteadyForces steady = steady_forces(held.body(), forces...);
    if (steady.linear_drag == 0) return turned_by(about_point(held, steady));
    return turned_by(TorqueAboutPoint<SteadyForces>{held, steady});
  } else {
    (require_followable(forces, held, std::abs(task.t1 - task.t0)), ...);
    return turned_by(TorqueAboutPoint<Forces>{held, forces}...);
  }
}

}  // namespace detail

/// The motion of a held body. A symmetric top that is held on its axis has a closed form under its
/// weight; what else is steady is followed by Taylor series.
/// @param start  at task.t0, as HeldBody::state() gives it
/// @param forces BodyForce each, on the body with its centre of mass: the joint takes up what would
///               move the point
/// @return the states of the centre of mass, with L about it; the error is that of these states, as
///         simulate() of a free body measures it, with the body's size about the point
/// @throws as simulate() of a free body, and std::invalid_argument if the held point moves
template <BodyForce<double>... Forces>
Trajectory simulate(const HeldBody& held, const RigidBodyState<>& start, const SimulationTask& task,
                    const Forces&... forces) {
  return detail::simulate_turning(held, held.turning_of(detail::valid_start(start)), task,
                                  forces...);
}

/// @}

}  // namespace tumble
