#pragma once
/// @file
/// The turning of a body under steady forces over a span of time, by Taylor series of high order,
/// each as long as it is good.
///
/// Source: Jorba & Zou, "A software package for the numerical integration of ODEs by means of
/// high-order Taylor methods", Experimental Mathematics 14 (2005), §3.2: high orders and long steps
/// cost least where the tolerance is tight.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/steady/turning_series.hpp"

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
  /// @throws std::runtime_error if the body turns so fast that steps no longer advance t, or after
  ///         max_steps
  TurningBySeries(const SteadyTorque& torque, const TurningState& start, double t0, double t1,
                  double tolerance)
      : series_(torque, detail::order_for(tolerance)) {
    double t = t0;
    steps_.push_back({t, start});
    while (t < t1) {
      series_.expand(steps_.back().state);
      const double next = std::min(t + series_.step(tolerance), t1);
      check(t, next);
      steps_.push_back({next, series_.at(next - t)});
      t = next;
    }
  }

  static constexpr int max_steps = 10'000'000;

  int order() const { return series_.order(); }
  int steps() const { return static_cast<int>(steps_.size()) - 1; }
  double time(int i) const { return steps_[static_cast<std::size_t>(i)].t; }
  const TurningState& end() const { return steps_.back().state; }

  /// Any t between t0 and t1: a part of the step that it is in.
  TurningState at(double t) const {
    const auto later = [](double time, const Step& step) { return time < step.t; };
    const auto after = std::upper_bound(steps_.begin() + 1, steps_.end(), t, later);
    const Step& step = *(after - 1);
    if (t == step.t) return step.state;
    detail::TurningSeries<rank> series = series_;
    series.expand(step.state);
    return series.at(t - step.t);
  }

 private:
  struct Step {
    double t;
    TurningState state;
  };

  void check(double t, double next) const {
    if (next > t && steps() < max_steps) return;
    std::ostringstream text;
    text.precision(17);
    text << "turning by series: " << (next > t ? "too many steps" : "the step became too small")
         << " at t = " << t << " with a step of h = " << next - t
         << ": the body turns by too many radians; ask for a shorter time";
    detail::throw_error<std::runtime_error>(text.str());
  }

  detail::TurningSeries<rank> series_;
  std::vector<Step> steps_;
};

/// @}

}  // namespace tumble::steady
