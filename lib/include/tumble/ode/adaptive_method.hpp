#pragma once
/// @file
/// What integrate_adaptive asks of a method: to try a step, to judge it and to propose
/// the next one.
///
/// What a method keeps from one step to the next (the last derivative, a Jacobian, a
/// factorisation) is in its Stepper; the way from t0 to t1, the counting and the refusals
/// are in integrate_adaptive.

#include "tumble/ode/tolerances.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// A step that was tried.
template <OdeState State>
struct Attempt {
  State y;                ///< where it leads, of use if it is accepted
  ScalarOf<State> error;  ///< its error_norm(): NaN if f had no value, ∞ if there is no such step
  ScalarOf<State> next_h;  ///< the step to try next, from here or from the end of this one

  bool accepted() const { return error <= 1; }
};

/// `Method::Stepper<State>`, made of the tolerances and f(t0, y0), can attempt steps, and
/// `Method::error_order` is q where the estimated error falls as h^(q+1).
template <class Method, class F, class State>
concept AdaptiveMethod = OdeRhs<F, State> &&
    std::constructible_from<typename Method::template Stepper<State>, Tolerances, State> &&
    requires(typename Method::template Stepper<State> stepper, F& f, ScalarOf<State> t,
             const State& y, ScalarOf<State> h) {
  { Method::error_order } -> std::convertible_to<int>;
  { stepper.attempt(f, t, y, h) } -> std::same_as<Attempt<State>>;
};

/// @}

}  // namespace tumble::runge_kutta
