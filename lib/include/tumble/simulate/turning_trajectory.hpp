#pragma once
/// @file
/// A body under steady forces: its path in closed form, its turning by Taylor series.

#include <algorithm>
#include <vector>

#include "tumble/body/steady_forces.hpp"
#include "tumble/core/largest.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/simulate/computed_trajectory.hpp"
#include "tumble/simulate/motion_tolerance.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/stated_error.hpp"
#include "tumble/simulate/trajectory.hpp"
#include "tumble/steady/steady_path.hpp"
#include "tumble/steady/turning_by_series.hpp"

namespace tumble::detail {

/// One integration of the turning, beside the path.
template <int rank>
class SteadyTrajectory {
 public:
  /// A step ends where the last terms of its series are as large as the tolerance. What is left out
  /// is smaller: of steps in random scenes 3 to 9 times at the median, 25 to 110 times for one in a
  /// hundred. The rough run starts ε/margin beside, so d shows what the motion makes of that.
  static constexpr double margin = 100;
  /// The order changes with the tolerance, so errors are only roughly in proportion to it: in
  /// random scenes seldom more than 10 times larger.
  static constexpr double careful = 20;

  /// @throws std::runtime_error as TurningBySeries does
  SteadyTrajectory(const steady::SteadyTorque& torque, const steady::SteadyPath& path,
                   const RigidBodyState<>& start, double t0, double t1, double tolerance)
      : torque_(torque),
        path_(path),
        t0_(t0),
        turning_(torque, torque.turning(start.q, start.L), 0, t1 - t0, tolerance) {}

  int steps() const { return turning_.steps(); }
  int order() const { return turning_.order(); }

  std::vector<double> times(double t1) const {
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(steps()) + 1);
    for (int i = 0; i < steps(); ++i) times.push_back(t0_ + turning_.time(i));
    times.push_back(t1);
    return times;
  }

  RigidBodyState<> at(double t) const {
    const double s = t - t0_;
    const steady::TurningState state = turning_.at(s);
    return {path_.x(s), torque_.orientation(state), path_.P(s), torque_.L(state)};
  }

  /// By how much the body turns, more or less.
  double radians() const {
    double sum = 0;
    for (int i = 1; i <= steps(); ++i)
      sum += (turning_.time(i) - turning_.time(i - 1)) * turning_.state(i).omega.norm();
    return sum;
  }

  /// The largest |L| at the ends of the steps [kg m²/s].
  double largest_L() const {
    double L = 0;
    for (int i = 0; i <= steps(); ++i) L = largest({L, torque_.L(turning_.state(i)).norm()});
    return L;
  }

  /// The largest difference at the ends of another run's steps: the angle between orientations
  /// [rad], and of L as a part of its largest size, but at least of least_L.
  double difference(const SteadyTrajectory& other, double least_L) const {
    double L = least_L, angle = 0, off = 0;
    for (int i = 0; i <= other.steps(); ++i) {
      const steady::TurningState theirs = other.turning_.state(i);
      const steady::TurningState ours = turning_.at(other.turning_.time(i));
      const Vec3 right = torque_.L(ours);
      L = std::max(L, right.norm());
      angle = largest({angle, angle_between(ours.q, theirs.q)});
      off = largest({off, (right - torque_.L(theirs)).norm()});
    }
    return largest({angle, off / L});
  }

  void account(SimulationReport& report) const {
    ++report.runs;
    report.steps += steps();
    report.evaluations += steps();
  }

 private:
  steady::SteadyTorque torque_;
  steady::SteadyPath path_;
  double t0_;
  steady::TurningBySeries<rank> turning_;
};

/// The torque in the body's own axes where they are principal axes, in whatever order: turning into
/// others would round the start, and a body that is balanced exactly would fall.
steady::SteadyTorque torque_for_series(const RigidBody<>& body, const SteadyForces& forces,
                                       const steady::SteadyTorque& torque);

/// What a rough and a fine run differ by.
/// @param tolerance of the fine run
template <int rank>
TwoRuns compared(const SteadyTrajectory<rank>& fine, const SteadyTrajectory<rank>& rough,
                 double least_L, double epsilon, double tolerance) {
  const double L = fine.largest_L();
  return {fine.difference(rough, least_L),
          L > least_motion * least_L && L < least_L ? fine.difference(rough, L) : 0,
          epsilon,
          tolerance,
          fine.steps(),
          fine.radians()};
}

/// Whether errors grow so much that what is left of all of them is one number: where the body comes
/// near a balance that does not last. Then those of the steps may cancel, and the runs agree by
/// luck. With other steps, and from the other side of the start, they do not.
template <class Run>
bool may_agree_by_luck(const TwoRuns& runs) {
  constexpr double much = 1000;
  return Run::margin * runs.difference > much * runs.epsilon;
}

/// The turning; it meets the tolerance unless rounding forbids.
template <int rank>
Trajectory turning_trajectory(const steady::SteadyTorque& torque, const steady::SteadyPath& path,
                              const RigidBody<>& body, const RigidBodyState<>& start,
                              const SimulationTask& task) {
  using Run = SteadyTrajectory<rank>;
  constexpr double first = 10, finer = 1e-3, finest = 1e-16, lowest = 10 * finest;
  const double least_L = least_sizes(body, task.t1 - task.t0).angular_momentum;
  const double lost = rounding_of_moments(body.I_body(), torque.axes().moments.minCoeff());
  const double of_path = path.error_bound(task.t1 - task.t0);
  SimulationReport report{
      .model = Model::full_body, .why = "steady forces turn the body", .tolerance = task.tolerance};
  const auto run = [&](const RigidBodyState<>& from, double tolerance) {
    return Run(torque, path, from, task.t0, task.t1, tolerance);
  };
  const Zeros zeros = torque.axes().R.isIdentity(0) ? Zeros::stay : Zeros::move;
  double epsilon = std::clamp(first * task.tolerance, lowest, 1e-2);
  while (true) {
    const double fine_tolerance = std::max(finer * epsilon, finest);
    // By some roundings at least: what they make of the start is in both runs alike.
    const double part = std::max(epsilon / Run::margin, 4 * unit_roundoff);
    const Run rough = run(beside(start, part, zeros), epsilon);
    Run fine = run(start, fine_tolerance);
    rough.account(report);
    fine.account(report);
    TwoRuns runs = compared(fine, rough, least_L, epsilon, fine_tolerance);
    state_errors<Run>(report, runs, lost, of_path);
    if (may_agree_by_luck<Run>(runs) && report.reached()) {
      const Run other = run(beside(start, -part, zeros), 0.5 * epsilon);
      other.account(report);
      const TwoRuns more = compared(fine, other, least_L, epsilon, fine_tolerance);
      runs.difference = largest({runs.difference, more.difference});
      runs.of_small = largest({runs.of_small, more.of_small});
      state_errors<Run>(report, runs, lost, of_path);
    }
    if (report.reached() || epsilon == lowest || of_path > task.tolerance) {
      report.method = "Taylor series of order " + std::to_string(fine.order());
      return trajectory_of(std::move(fine), task, report);
    }
    epsilon = next_epsilon(epsilon, task.tolerance, report.error_estimate, lowest);
  }
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/turning_trajectory.inl"
#endif
