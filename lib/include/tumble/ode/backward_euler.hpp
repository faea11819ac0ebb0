#pragma once
/// @file
/// Backward Euler: the slope at the end of the step, which has to be found.
///
///     y₁ = y + h f(t + h, y₁),   by Newton:  (I − h ∂f/∂y) Δ = y + h f(t + h, y₁) − y₁
///
/// However stiff the problem, the step need not be short for the method to be stable.
/// Source: Hairer & Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.3.

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "tumble/core/require.hpp"
#include "tumble/ode/jacobian.hpp"
#include "tumble/ode/linear_solver.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// The state one step later.
/// @param f right-hand side of y' = f(t, y), with f.jacobian(t, y) if it knows one
/// @param h step, negative to go back in time
/// @throws std::runtime_error if Newton's iteration does not converge
template <OdeState State, OdeRhs<State> F>
State backward_euler_step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
  using std::max, std::sqrt;
  using Scalar = ScalarOf<State>;
  using Matrix = detail::JacobianOf<State>;
  constexpr int max_iterations = 25;
  // Newton converges quadratically: after a correction of √ε, what is left is of the size of ε.
  const Scalar tolerance = sqrt(std::numeric_limits<Scalar>::epsilon());

  State y1 = y;
  for (int i = 0; i < max_iterations; ++i) {
    const State dydt = f(t + h, y1);
    const Matrix J = detail::jacobian(f, t + h, y1, dydt, h);
    const Matrix A = Matrix::Identity(y.size(), y.size()) - h * J;
    const State residual = y + h * dydt - y1;
    detail::LinearSolver<Matrix> factors;
    factors.compute(A);
    const State correction = factors.solve(residual);
    y1 += correction;
    if (!y1.allFinite()) break;  // the matrix is singular, or f has no value there
    if (correction.norm() <= tolerance * max(y.norm(), y1.norm())) return y1;
  }
  detail::throw_error<std::runtime_error>(
      "backward_euler_step: Newton's iteration does not converge from t = ", t, " with h = ", h,
      ": take a shorter step");
}

/// Backward Euler as a type, for integrate_fixed<runge_kutta::BackwardEuler>.
struct BackwardEuler {
  static constexpr int order = 1;

  template <OdeState State, OdeRhs<State> F>
  static State step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
    return backward_euler_step(f, t, y, h);
  }
};

/// @}

}  // namespace tumble::runge_kutta
