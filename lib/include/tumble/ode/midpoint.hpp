#pragma once
/// @file
/// The midpoint method: take half a step of Euler's to see the slope there, then the whole step.
///
///     k₁ = f(t, y),   y(t + h) = y + h f(t + h/2, y + h/2 k₁) + O(h³)
///
/// Source: Runge (1895); Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I",
/// 2nd ed. (1993), eq. II.1.4.

#include "tumble/ode/rhs.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// The state one step later.
/// @param f right-hand side of y' = f(t, y)
/// @param h step, negative to go back in time
template <OdeState State, OdeRhs<State> F>
State midpoint_step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
  const ScalarOf<State> half = h / ScalarOf<State>(2);
  const State k1 = f(t, y);
  const State k2 = f(t + half, State(y + half * k1));
  return y + h * k2;
}

/// The midpoint method as a type, for integrate_fixed<runge_kutta::Midpoint>.
struct Midpoint {
  static constexpr int order = 2;

  template <OdeState State, OdeRhs<State> F>
  static State step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
    return midpoint_step(f, t, y, h);
  }
};

/// @}

}  // namespace tumble::runge_kutta
