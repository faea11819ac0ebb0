#pragma once
/// @file
/// What a simulation gives: the state at any time of the span, and an account of how it was made.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
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
  /// The error of what moves less than simulate() calls large enough to matter, as a part of how
  /// far it does move; 0 if nothing is so small, or if error_estimate says the same.
  double error_of_small_motion = 0;
  int runs = 0;         ///< integrations from t0 to t1; 0 for a closed form
  int steps = 0;        ///< of all runs
  int rejected = 0;     ///< of all runs
  int evaluations = 0;  ///< of the forces, or expansions into a series

  /// Whether the tolerance was kept, as far as can be told. If not, error_estimate says what was.
  bool reached() const { return error_estimate <= tolerance; }
};

namespace detail {

/// Of parts of a motion, or of bodies beside each other: the largest error, and the costs of all.
void add_report(SimulationReport& all, const SimulationReport& one);

/// A motion of a span of time, however it is known.
template <class State>
class AnyTrajectory {
 public:
  virtual ~AnyTrajectory() = default;
  virtual State at(double t) const = 0;
  /// t0 … t1, so close that the motion between two of them is simple.
  virtual std::vector<double> times() const = 0;
};

}  // namespace detail

/// The motion of a body, or of several, from t0 to t1. Copies share what was computed; any number
/// of threads may ask at the same time.
/// @tparam State RigidBodyState<>, or a std::vector of it, one of each body
template <class State>
class TrajectoryOf {
 public:
  TrajectoryOf(std::shared_ptr<const detail::AnyTrajectory<State>> motion, double t0, double t1,
               SimulationReport report)
      : motion_(std::move(motion)), t0_(t0), t1_(t1), report_(std::move(report)) {}

  double t0() const { return t0_; }  ///< [s]
  double t1() const { return t1_; }  ///< [s], before t0 where the motion was asked for backwards
  /// t0 … t1, so close that the motion between two of them is simple [s].
  std::vector<double> times() const { return motion_->times(); }
  const SimulationReport& report() const { return report_; }
  State end() const { return motion_->at(t1_); }

  /// The state at time t [s]. Beyond an end by rounding, as t1 * i / n may be, t is that end.
  /// @throws std::invalid_argument if t is not between t0 and t1
  State at(double t) const {
    const double first = std::min(t0_, t1_), last = std::max(t0_, t1_);
    const double inside = std::clamp(t, first, last);
    constexpr double few = 4 * std::numeric_limits<double>::epsilon();
    require(std::abs(t - inside) <= few * std::max(std::abs(first), std::abs(last)),
            "Trajectory: t = ", t, " is not in ", t0_, " … ", t1_, ", but outside by ",
            std::abs(t - inside));
    return motion_->at(inside);
  }

 private:
  std::shared_ptr<const detail::AnyTrajectory<State>> motion_;
  double t0_, t1_;
  SimulationReport report_;
};

/// The motion of a body.
using Trajectory = TrajectoryOf<RigidBodyState<>>;

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/trajectory.inl"
#endif
