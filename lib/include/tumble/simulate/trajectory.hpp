#pragma once
/// @file
/// What a simulation gives: the state at any time of the span, and an account of how it was made.

#include <functional>
#include <string>
#include <vector>

#include "tumble/body/model.hpp"
#include "tumble/body/state.hpp"
#include "tumble/core/require.hpp"

namespace tumble {

/// @addtogroup simulate
/// @{

/// What was chosen, why, what error is left and what it cost.
struct SimulationReport {
  Model model = Model::full_body;  ///< the simplest that is exact for the scene
  std::string method = {};         ///< in words
  std::string why = {};            ///< in words
  double tolerance = 0;            ///< what was asked for
  double error_estimate = 0;       ///< in the same units
  int runs = 0;                    ///< integrations from t0 to t1; 0 for a closed form
  int steps = 0;                   ///< of all runs
  int rejected = 0;                ///< of all runs
  int evaluations = 0;             ///< of the forces, or expansions into a series

  /// Whether the tolerance was kept, as far as can be told. If not, error_estimate says what was.
  bool reached() const { return error_estimate <= tolerance; }
};

/// The motion of a body from t0 to t1.
class Trajectory {
 public:
  /// @param at    the state at any time of the span
  /// @param times t0 … t1, ascending, so close that the motion between two of them is simple
  Trajectory(std::function<RigidBodyState<>(double)> at, std::vector<double> times,
             SimulationReport report)
      : at_(std::move(at)), times_(std::move(times)), report_(std::move(report)) {}

  double t0() const { return times_.front(); }                 ///< [s]
  double t1() const { return times_.back(); }                  ///< [s]
  const std::vector<double>& times() const { return times_; }  ///< [s]
  const SimulationReport& report() const { return report_; }
  RigidBodyState<> end() const { return at_(t1()); }

  /// The state at time t [s].
  /// @throws std::invalid_argument if t is not between t0 and t1
  RigidBodyState<> at(double t) const {
    require(t >= t0() && t <= t1(), "Trajectory: t = ", t, " is not in ", t0(), " … ", t1());
    return at_(t);
  }

 private:
  std::function<RigidBodyState<>(double)> at_;
  std::vector<double> times_;
  SimulationReport report_;
};

/// @}

}  // namespace tumble
