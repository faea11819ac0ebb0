#pragma once
/// @file
/// How long the next step should be.
///
/// The error of a step grows as hᵠ⁺¹, so with ‖e‖ measured at h the step that would just
/// be allowed is
///
///     h_new = h · 0.9 · ‖e‖^(−1/(q+1)),   0.2 ≤ h_new/h ≤ 10
///
/// A factor ‖e_before‖^β as well (PI control) gains little: at β = 0.04 DormandPrince54 needs 0, 0
/// and 10 % fewer evaluations for the same error in the three problems of the benchmark, and Dop853
/// 4 % more, 1 and 12 % fewer.
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// II.4: eqs. 4.12 and 4.13, and the algorithm "Starting Step Size".

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "tumble/ode/tolerances.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// The step to try next.
/// @param h     the step just tried
/// @param error its error_norm(); NaN counts as far too large
/// @param order q, where the error falls as h^(q+1)
template <class Scalar>
Scalar adaptive_step_size(Scalar h, std::type_identity_t<Scalar> error, int order) {
  using std::pow;
  const auto safety = Scalar(0.9), min_factor = Scalar(0.2), max_factor = Scalar(10);
  if (error != error) return h * min_factor;
  if (error == 0) return h * max_factor;
  const Scalar factor = safety * pow(error, Scalar(-1) / static_cast<Scalar>(order + 1));
  return h * std::clamp(factor, min_factor, max_factor);
}

/// @}

}  // namespace tumble::runge_kutta

namespace tumble::detail {

/// A first step, from the sizes of y, y' and y'' at the start: what a step of Euler's method that
/// moves y by 1 % of its scale says about the second derivative.
/// @param dydt0 f(t0, y0)
/// @param span  t1 − t0; its sign is the direction, and the step is not longer
/// @param order q, where the error falls as h^(q+1)
template <OdeState State, OdeRhs<State> F, class Tolerance = Tolerances>
ScalarOf<State> initial_step_size(F&& f, ScalarOf<State> t0, const State& y0, const State& dydt0,
                                  ScalarOf<State> span, int order, const Tolerance& tolerances) {
  using runge_kutta::error_norm;
  using std::abs, std::copysign, std::max, std::min, std::pow;
  using Scalar = ScalarOf<State>;
  const auto norm = [&](const State& v) { return error_norm(v, y0, y0, tolerances); };
  const Scalar d0 = norm(y0), d1 = norm(dydt0);
  const auto tiny = Scalar(1e-5), guess = Scalar(1e-6), small_part = Scalar(0.01);
  const Scalar h0 = min(d0 < tiny || d1 < tiny ? guess : small_part * d0 / d1, abs(span));

  const Scalar step = copysign(h0, span);
  const State dydt1 = f(t0 + step, State(y0 + step * dydt0));
  const Scalar d2 = norm(dydt1 - dydt0) / h0;
  if (!dydt1.allFinite()) return step / Scalar(100);  // the edge of where f is defined is near

  const Scalar largest = max(d1, d2);
  const Scalar h1 = largest <= Scalar(1e-15)
                        ? max(guess, h0 / Scalar(1000))
                        : pow(small_part / largest, Scalar(1) / static_cast<Scalar>(order + 1));
  return copysign(min(min(Scalar(100) * h0, h1), abs(span)), span);
}

}  // namespace tumble::detail
