#pragma once
/// @file
/// What a solver of y' = f(t, y) asks of the state y and of the right-hand side f.
///
/// Everything that moves is flattened into one column vector y, and f says how fast it changes. The
/// solvers know nothing else about the problem (Witkin & Baraff, "Physically Based Modeling",
/// SIGGRAPH course notes 2001, "Differential Equation Basics").

#include <cmath>
#include <concepts>

#include "tumble/core/require.hpp"
#include "tumble/core/time_span.hpp"
#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup ode
/// @{

/// A column vector that owns its numbers: Eigen::VectorXd, Vec3, Eigen::Matrix<float, 13, 1>, …
/// One of fixed size keeps every solver off the heap.
template <class State>
concept OdeState =
    std::derived_from<State, Eigen::MatrixBase<State>> &&
    std::same_as<State, typename State::PlainObject> && State::ColsAtCompileTime == 1;

/// The numbers a state is made of, and time too.
template <class State>
using ScalarOf = typename State::Scalar;

/// A callable f(t, y) that gives dy/dt. A lambda must not return an Eigen expression of its own
/// local variables: write `-> State` behind its parameters.
template <class F, class State>
concept OdeRhs = OdeState<State> && requires(F& f, ScalarOf<State> t, const State& y) {
  { f(t, y) } -> std::convertible_to<State>;
};

/// @}

}  // namespace tumble

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// A callable observe(t, y) that is told of every step.
template <class F, class State>
concept OdeObserver = OdeState<State> && requires(F& observe, ScalarOf<State> t, const State& y) {
  observe(t, y);
};

/// @}

}  // namespace tumble::runge_kutta

namespace tumble::detail {

/// Refuses a start or a span of time that is no number.
/// @param who the function that asks, for the message
/// @throws std::invalid_argument if y0, t0, t1 or t1 − t0 is not finite, or that is below 2e-308
template <OdeState State>
void require_finite(const char* who, const State& y0, ScalarOf<State> t0, ScalarOf<State> t1) {
  using std::isfinite;  // a dual number brings its own
  require(isfinite(t0) && isfinite(t1), who, ": from t0 = ", t0, " to t1 = ", t1,
          " is not a finite span");
  require(is_time(t1 - t0), who, ": t1 − t0 = ", t1 - t0, " from t0 = ", t0, " to t1 = ", t1,
          " is a span that doubles have no digits for");
  require(y0.allFinite(), who, ": y0 = (", y0.transpose(), ") is not finite");
}

/// The observer of someone who only wants the end.
struct IgnoreSteps {
  template <class Time, class State>
  void operator()(const Time&, const State&) const {}
};

}  // namespace tumble::detail
