#pragma once
/// @file
/// The turning of a body under steady forces over a span of time, by Taylor series of high order,
/// each as long as it is good; what drag alone slows, in closed form in the end, see slowing.hpp.
///
/// Source: Jorba & Zou, "A software package for the numerical integration of ODEs by means of
/// high-order Taylor methods", Experimental Mathematics 14 (2005), §3.2: high orders and long steps
/// cost least where the tolerance is tight.

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/core/step_at.hpp"
#include "tumble/core/step_budget.hpp"
#include "tumble/steady/slowing.hpp"
#include "tumble/steady/turning_series.hpp"
#include "tumble/steady/turning_term.hpp"

namespace tumble::detail {

/// An even order that is good for steps with this tolerance: measured on free bodies and tops.
inline int order_for(double tolerance) {
  const int order = 2 * static_cast<int>(std::lround((10 - 1.3 * std::log10(tolerance)) / 2));
  return std::clamp(order, 8, TurningSeries<0>::max_order);
}

}  // namespace tumble::detail

namespace tumble::steady {

/// @addtogroup steady
/// @{

/// The steps of a turning, and what is between them.
template <int rank>
class TurningBySeries {
 public:
  /// @param t0, t1    [s], t1 ≥ t0
  /// @param tolerance of a step: of q in radians, of ω relative to it
  /// @throws std::runtime_error if the body turns so fast that steps no longer advance t, or if it
  ///         would take more than max_steps, which is said soon
  TurningBySeries(const SteadyTorque& torque, const TurningState& start, double t0, double t1,
                  double tolerance)
      : torque_(torque), series_(torque, detail::order_for(tolerance)) {
    // Behind its slowing there are no steps.
    detail::StepBudget budget(t0, std::min(t1, t0 + detail::time_to_slow(torque, start)),
                              max_steps);
    double t = t0;
    steps_.push_back({t, start, 1});
    while (t < t1 && !detail::only_slows(torque, steps_.back().state)) {
      series_.expand(steps_.back().state);
      const double next = std::min(t + series_.step(tolerance), t1);
      if (!(next > t)) stop(t, next);
      if (steps_.size() <= max_kept) series_.keep(kept_);
      steps_.back().unit = series_.unit();
      steps_.push_back({next, series_.at(next - t), 1});
      budget.count(next);
      if (budget.hopeless())
        detail::refuse_hopeless("turning by series", budget, max_steps, next,
                                advice(torque, t1 - t0));
      t = next;
    }
    if (t < t1) steps_.push_back({t1, detail::slowed(torque, steps_.back().state, t1 - t), 1});
  }

  static constexpr int max_steps = 2'000'000;

  int order() const { return series_.order(); }
  int steps() const { return static_cast<int>(steps_.size()) - 1; }
  double time(int i) const { return steps_[static_cast<std::size_t>(i)].t; }
  const TurningState& state(int i) const { return steps_[static_cast<std::size_t>(i)].state; }
  const TurningState& end() const { return steps_.back().state; }

  /// Any t between t0 and t1: a part of the step that it is in.
  TurningState at(double t) const {
    if (t >= steps_.back().t) return steps_.back().state;
    const std::size_t i = detail::step_at(steps_, t, [](const Step& step) { return step.t; });
    const Step& step = steps_[i];
    if (t == step.t) return step.state;
    const auto terms = static_cast<std::size_t>(order()) + 1;
    if (i * terms < kept_.size()) {
      const double h = (t - step.t) / step.unit;
      const TurningState s = detail::turning_at(kept_.data() + i * terms, series_.order(), h);
      return {s.q, s.omega / step.unit};
    }
    if (detail::only_slows(torque_, step.state))
      return detail::slowed(torque_, step.state, t - step.t);
    detail::TurningSeries<rank> series = series_;
    series.expand(step.state);
    return series.at(t - step.t);
  }

 private:
  struct Step {
    double t;
    TurningState state;
    double unit;  // of time, of the terms from here on [s]
  };

  /// Steps whose series are kept (20 MB); later ones are expanded anew.
  static constexpr std::size_t max_kept = 10'000;

  static const char* advice(const SteadyTorque& torque, double span) {
    constexpr double stiff = 1e5;  // times that drag would have stopped a free body
    if (torque.drag().maxCoeff() * span > stiff)
      return "its angular drag makes it stiff; ask for a shorter time, or give simulate() the drag "
             "as a function: then it takes a method for stiff scenes";
    return "the body turns by too many radians; ask for a shorter time";
  }

  [[noreturn]] static void stop(double t, double next) {
    detail::throw_error<std::runtime_error>(
        std::setprecision(17), "turning by series: the step became too small at t = ", t,
        " with a step of h = ", next - t,
        ": the body turns by too many radians; ask for a shorter time");
  }

  SteadyTorque torque_;
  detail::TurningSeries<rank> series_;
  std::vector<Step> steps_;
  std::vector<detail::TurningTerm> kept_;
};

/// @}

}  // namespace tumble::steady
