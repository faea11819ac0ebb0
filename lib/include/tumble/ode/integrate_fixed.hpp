#pragma once
/// @file
/// Steps of one size from t0 to t1, with any method that can take a step.
///
/// The times are t0 + i h, each computed afresh: a sum of a million steps would have drifted.

#include "tumble/ode/rhs.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// A method that can take one step, and the order of its error: Euler, Midpoint, Rk4,
/// DormandPrince54, Dop853, BackwardEuler, Radau5.
template <class Method, class F, class State>
concept StepMethod = OdeRhs<F, State> &&
    requires(F& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
  { Method::order } -> std::convertible_to<int>;
  { Method::step(f, t, y, h) } -> std::convertible_to<State>;
};

/// @}

}  // namespace tumble::runge_kutta

namespace tumble {

/// @addtogroup ode
/// @{

/// The state at t1, after `steps` steps of size h = (t1 − t0) / steps.
/// @param f       right-hand side of y' = f(t, y)
/// @param observe called as observe(t, y) after each step
/// @throws std::invalid_argument if steps < 1, y0, t0, t1 or t1 − t0 is not finite, or h is not 0
///         and below 2e-308
template <class Method, OdeState State, OdeRhs<State> F,
          runge_kutta::OdeObserver<State> Observer = detail::IgnoreSteps>
State integrate_fixed(F&& f, const State& y0, ScalarOf<State> t0, ScalarOf<State> t1, int steps,
                      Observer&& observe = {}) {
  static_assert(runge_kutta::StepMethod<Method, F, State>,
                "integrate_fixed<Method>: a method like Rk4");
  using Scalar = ScalarOf<State>;
  require(steps >= 1, "integrate_fixed: steps = ", steps, ", but at least one is needed");
  detail::require_finite("integrate_fixed", y0, t0, t1);

  const Scalar h = (t1 - t0) / static_cast<Scalar>(steps);
  require(detail::is_time(h), "integrate_fixed: ", steps, " steps from t0 = ", t0, " to t1 = ", t1,
          " are of h = ", h, " each, which has no digits: take fewer");
  const auto time = [&](int i) { return i == steps ? t1 : t0 + static_cast<Scalar>(i) * h; };
  State y = y0;
  for (int i = 0; i < steps; ++i) {
    if (h != Scalar(0)) y = Method::step(f, time(i), y, h);  // implicit methods divide by it
    observe(time(i + 1), y);
  }
  return y;
}

/// @}

}  // namespace tumble
