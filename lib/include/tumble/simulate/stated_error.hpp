#pragma once
/// @file
/// An error that is kept over the whole span, not step by step: a motion is computed twice, with
/// rough and with fine steps.
///
/// What the two differ by, d, is the rough run's error: its tolerance ε times what the motion makes
/// of errors. So the fine run, with a tolerance of 10⁻³ ε, has an error of about 10⁻³ d, and its
/// rounding makes one of about d u/ε for each step. If that is not good enough, both are run again
/// with an ε that is. How far proportion can be trusted, a Run says:
///
///     error_exponent   errors fall at least as tolerance^exponent: 1, or less where forces may be
///                      rough and now and then fool the control of steps
///     margin           how much smaller the error of a step is than its tolerance
///
/// Source: Shampine, "Error estimation and control for ODEs", J. Sci. Comput. 25 (2005), §5, on
/// tolerance proportionality and global errors.

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "tumble/core/rounding.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// How far two motions are from each other: the angle between orientations [rad], and everything
/// else as a part of its largest size on the way; the largest of these at some moments.
struct MotionScale {
  double length;            ///< [m]
  double momentum;          ///< [kg m/s]
  double angular_momentum;  ///< [kg m²/s]

  double difference(const RigidBodyState<>& a, const RigidBodyState<>& b) const {
    return std::max({angle_between(a.q, b.q), (a.x - b.x).norm() / length,
                     (a.P - b.P).norm() / momentum, (a.L - b.L).norm() / angular_momentum});
  }
};

/// What two runs show of the second one's error.
struct StatedError {
  double difference;  ///< between them
  double estimate;    ///< of the second one's error
};

/// @param rough, fine two runs of `at(t)`; the rough one's ε and the fine one's tolerance and steps
template <class Run>
StatedError stated_error(const Run& rough, const Run& fine, const MotionScale& scale, double t0,
                         double t1, double epsilon, double tolerance) {
  constexpr int samples = 8;
  double difference = 0;
  for (int i = 1; i <= samples; ++i) {
    const double t = i == samples ? t1 : t0 + i * (t1 - t0) / samples;
    difference = std::max(difference, scale.difference(rough.at(t), fine.at(t)));
  }
  constexpr double careful = 4;
  const double steps = std::sqrt(static_cast<double>(fine.steps()));
  const double share = careful * std::pow(tolerance / epsilon, Run::error_exponent) +
                       Run::margin * steps * unit_roundoff / epsilon;
  return {difference, std::min(1.0, share) * difference + unit_roundoff};
}

/// The fine run that keeps the tolerance, or the best that there is.
/// @param run run(start, tolerance of a step) → a Run with at(t), steps() and account(report)
/// @return the run; the report's error_estimate and costs are filled in
template <class Runner>
std::invoke_result_t<Runner, const RigidBodyState<>&, double> run_to_tolerance(
    const Runner& run, const RigidBodyState<>& start, const MotionScale& scale, double t0,
    double t1, SimulationReport& report) {
  using Run = std::invoke_result_t<Runner, const RigidBodyState<>&, double>;
  constexpr double finer = 1e-3, finest = 1e-16, lowest = 10 * finest;
  double epsilon = std::clamp(Run::first_epsilon * report.tolerance, lowest, 1e-2);
  while (true) {
    const double fine_tolerance = std::max(finer * epsilon, finest);
    const Run rough = run(start, epsilon);
    Run fine = run(start, fine_tolerance);
    rough.account(report);
    fine.account(report);
    const StatedError error = stated_error(rough, fine, scale, t0, t1, epsilon, fine_tolerance);
    report.error_estimate = error.estimate;
    if (report.reached() || epsilon == lowest) return fine;
    // What the difference says is needed, but by at most 1000 at a time: a large difference says
    // little.
    const double needed = epsilon * report.tolerance / (2 * error.estimate);
    epsilon = std::max(lowest, std::clamp(needed, epsilon / 1000, epsilon / 3));
  }
}

}  // namespace tumble::detail
