#pragma once
/// @file
/// The classical Runge–Kutta method: four slopes, weighted as in Simpson's rule.
///
///     y(t + h) = y + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄) + O(h⁵)
///
/// Source: Kutta (1901); Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I",
/// 2nd ed. (1993), table II.1.2.

#include "tumble/ode/rhs.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// The state one step later.
/// @param f right-hand side of y' = f(t, y)
/// @param h step, negative to go back in time
template <OdeState State, OdeRhs<State> F>
State rk4_step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
  using Scalar = ScalarOf<State>;
  const Scalar two(2), half = h / two, sixth = h / Scalar(6);
  const State k1 = f(t, y);
  const State k2 = f(t + half, State(y + half * k1));
  const State k3 = f(t + half, State(y + half * k2));
  const State k4 = f(t + h, State(y + h * k3));
  return y + sixth * (k1 + two * k2 + two * k3 + k4);
}

/// @}

}  // namespace tumble::runge_kutta

namespace tumble {

/// @addtogroup ode
/// @{

/// The classical Runge–Kutta method as a type, for integrate_fixed<Rk4>.
struct Rk4 {
  static constexpr int order = 4;

  template <OdeState State, OdeRhs<State> F>
  static State step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
    return runge_kutta::rk4_step(f, t, y, h);
  }
};

/// @}

}  // namespace tumble
