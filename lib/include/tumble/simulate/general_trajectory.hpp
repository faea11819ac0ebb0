#pragma once
/// @file
/// A body under any forces, by Dormand and Prince's method of order 8 on thirteen numbers that are
/// of the size of 1.

#include <algorithm>
#include <vector>

#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/simulate/scaled_rhs.hpp"
#include "tumble/simulate/stated_error.hpp"

namespace tumble::detail {

/// What is large and small in a scene: at least the motion through the body's own size, and the
/// turn by one radian, in the whole time.
template <class Rhs>
MotionScale scale_of(const Rhs& rhs, const RigidBodyState<>& start, double t0, double t1) {
  const RigidBody<>& body = rhs.body();
  const double span = t1 - t0, inertia = body.I_body().trace() / 3;
  const RigidBodyState<> rate = rhs.rate(t0, start);
  const double own_length = std::sqrt(inertia / body.mass());
  MotionScale scale;
  scale.momentum =
      std::max({start.P.norm(), rate.P.norm() * span, body.mass() * own_length / span});
  scale.length = std::max(start.x.norm(), scale.momentum / body.mass() * span);
  scale.angular_momentum = std::max({start.L.norm(), rate.L.norm() * span, inertia / span});
  return scale;
}

/// One integration from t0 to t1 whose steps can be gone into again.
template <class Rhs>
class GeneralTrajectory {
 public:
  static constexpr double error_exponent = 0.5, margin = 10, first_epsilon = 0.01;

  /// @param rhs a RigidBodyRhs<double, …>
  /// @throws std::runtime_error as integrate_adaptive() does
  GeneralTrajectory(const Rhs& rhs, const MotionScale& scale, const RigidBodyState<>& start,
                    double t0, double t1, double tolerance)
      : rhs_(rhs, scale) {
    steps_.push_back({t0, rhs_.numbers(start)});
    const auto keep = [this](double t, const Numbers& y) { steps_.push_back({t, y}); };
    const auto solution =
        integrate_adaptive<Dop853>(rhs_, steps_.front().y, t0, t1, {tolerance, tolerance}, keep);
    rejected_ = solution.rejected;
    evaluations_ = solution.evaluations;
  }

  int steps() const { return static_cast<int>(steps_.size()) - 1; }

  std::vector<double> times() const {
    std::vector<double> times;
    for (const Step& step : steps_) times.push_back(step.t);
    return times;
  }

  /// Any t between t0 and t1: a part of the step that it is in.
  RigidBodyState<> at(double t) const {
    const auto later = [](double time, const Step& step) { return time < step.t; };
    const Step& step = *(std::upper_bound(steps_.begin() + 1, steps_.end(), t, later) - 1);
    return rhs_.state(t == step.t ? step.y : Dop853::step(rhs_, step.t, step.y, t - step.t));
  }

  void account(SimulationReport& report) const {
    ++report.runs;
    report.steps += steps();
    report.rejected += rejected_;
    report.evaluations += evaluations_;
  }

 private:
  using Numbers = typename ScaledRhs<Rhs>::Numbers;
  struct Step {
    double t;
    Numbers y;
  };

  ScaledRhs<Rhs> rhs_;
  std::vector<Step> steps_;
  int rejected_ = 0, evaluations_ = 0;
};

}  // namespace tumble::detail
