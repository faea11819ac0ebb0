#pragma once
/// @file
/// Euler's method: follow the tangent.
///
///     y(t + h) = y + h f(t, y) + O(h²)
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed.
/// (1993), eq. I.7.3.

#include "tumble/ode/rhs.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// The state one step later.
/// @param f right-hand side of y' = f(t, y)
/// @param h step, negative to go back in time
template <OdeState State, OdeRhs<State> F>
State euler_step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
  const State k = f(t, y);
  return y + h * k;
}

/// Euler's method as a type, for integrate_fixed<runge_kutta::Euler>.
struct Euler {
  static constexpr int order = 1;

  template <OdeState State, OdeRhs<State> F>
  static State step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
    return euler_step(f, t, y, h);
  }
};

/// @}

}  // namespace tumble::runge_kutta
