#pragma once
/// @file
/// A body under steady forces: its path in closed form, its turning by Taylor series.

#include <memory>
#include <vector>

#include "tumble/simulate/stated_error.hpp"
#include "tumble/steady/steady_path.hpp"
#include "tumble/steady/turning_by_series.hpp"

namespace tumble::detail {

/// One integration of the turning, beside the path.
template <int rank>
class SteadyTrajectory {
 public:
  static constexpr double error_exponent = 1, margin = 100, first_epsilon = 10;

  /// @throws std::runtime_error as TurningBySeries does
  SteadyTrajectory(const steady::SteadyTorque& torque, const steady::SteadyPath& path,
                   const RigidBodyState<>& start, double t0, double t1, double tolerance)
      : torque_(torque),
        path_(path),
        t0_(t0),
        turning_(torque, torque.turning(start.q, start.L), t0, t1, tolerance) {}

  int steps() const { return turning_.steps(); }
  int order() const { return turning_.order(); }

  std::vector<double> times() const {
    std::vector<double> times;
    for (int i = 0; i <= steps(); ++i) times.push_back(turning_.time(i));
    return times;
  }

  RigidBodyState<> at(double t) const {
    const steady::TurningState s = turning_.at(t);
    return {path_.x(t - t0_), torque_.orientation(s), path_.P(t - t0_), torque_.L(s)};
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

}  // namespace tumble::detail
