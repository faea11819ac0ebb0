#pragma once
/// @file
/// From t0 to t1 with steps as long as the tolerances allow.
///
/// A step whose error_norm() is above 1 is tried again, shorter; the error of one that is kept says
/// how long the next may be. Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential
/// Equations I", 2nd ed. (1993), II.4 "Automatic Step Size Control".

#include <iomanip>
#include <limits>
#include <stdexcept>

#include "tumble/core/require.hpp"
#include "tumble/ode/adaptive_method.hpp"
#include "tumble/ode/counted_rhs.hpp"
#include "tumble/ode/step_size.hpp"

namespace tumble {

/// @addtogroup ode
/// @{

/// Where the integration ended and what it cost.
template <OdeState State>
struct OdeSolution {
  State y;              ///< the state at t1
  int steps = 0;        ///< accepted
  int rejected = 0;     ///< tried in vain
  int evaluations = 0;  ///< of f, also for a Jacobian by finite differences
};

namespace detail {

/// Tried steps after which integrate_adaptive gives up.
inline constexpr int max_attempts = 1'000'000;

/// @throws std::runtime_error that says why the solver stopped, where, and what to do
template <class Scalar>
[[noreturn]] void stop_integration(const char* why, Scalar t, Scalar h, const char* advice) {
  detail::throw_error<std::runtime_error>(
      std::setprecision(std::numeric_limits<Scalar>::max_digits10), "integrate_adaptive: ", why,
      " at t = ", t, " with a step of h = ", h, ": ", advice);
}

/// The refusals that keep an integration from going on for ever.
template <OdeState State>
void require_progress(const runge_kutta::Attempt<State>& attempt, ScalarOf<State> t,
                      ScalarOf<State> h, bool is_shortest, int attempts) {
  if (!attempt.accepted() && is_shortest) {
    if (attempt.error != attempt.error)
      stop_integration("dydt is not finite", t, h,
                       "the solution leaves the domain of dydt here; end the integration before");
    stop_integration("the step became too small", t, h,
                     "the solution has a singularity here, or the tolerances are below rounding");
  }
  if (attempts >= max_attempts)
    stop_integration("too many steps", t, h,
                     "if the problem is stiff, use Radau5; else integrate in several parts");
}

}  // namespace detail

/// The state at t1 > t0 or t1 < t0, with an estimated error per step within the tolerances.
/// @tparam Method  DormandPrince54, Dop853 or, for stiff problems, Radau5
/// @param f       right-hand side of y' = f(t, y)
/// @param observe called as observe(t, y) after each accepted step
/// @throws std::invalid_argument if y0, t0 or t1 is not finite or a tolerance not positive
/// @throws std::runtime_error if f is not finite where the solution goes, if no step is short
///         enough, or after max_attempts
template <class Method, OdeState State, OdeRhs<State> F,
          runge_kutta::OdeObserver<State> Observer = detail::IgnoreSteps>
OdeSolution<State> integrate_adaptive(F&& f, const State& y0, ScalarOf<State> t0,
                                      ScalarOf<State> t1, const Tolerances& tolerances = {},
                                      Observer&& observe = {}) {
  static_assert(runge_kutta::AdaptiveMethod<Method, runge_kutta::CountedRhs<F>, State>,
                "integrate_adaptive<Method>: a method like DormandPrince54");
  using std::abs, std::copysign;
  using Scalar = ScalarOf<State>;
  require_valid<Scalar>(tolerances);
  detail::require_finite("integrate_adaptive", y0, t0, t1);

  OdeSolution<State> solution{y0};
  if (t0 == t1) return solution;
  runge_kutta::CountedRhs<F> counted(f, solution.evaluations);
  const State dydt0 = counted(t0, y0);
  if (!dydt0.allFinite())
    detail::stop_integration("dydt is not finite", t0, t1 - t0, "it has no value at the start");

  typename Method::template Stepper<State> stepper(tolerances, dydt0);
  Scalar t = t0;
  Scalar h =
      detail::initial_step_size(counted, t0, y0, dydt0, t1 - t0, Method::error_order, tolerances);
  while (t != t1) {
    // A few units in the last place of t: a shorter step says nothing.
    const Scalar shortest = Scalar(8) * std::numeric_limits<Scalar>::epsilon() * abs(t);
    if (abs(h) < shortest) h = copysign(shortest, h);
    const bool is_shortest = abs(h) == shortest;
    // The last step is stretched by up to 1 % rather than followed by a tiny one.
    const Scalar next = abs(t1 - t) <= Scalar(1.01) * abs(h) ? t1 : t + h;
    h = next - t;  // as far as the rounded time leads, else late steps add up to another span

    const runge_kutta::Attempt<State> attempt = stepper.attempt(counted, t, solution.y, h);
    attempt.accepted() ? ++solution.steps : ++solution.rejected;
    detail::require_progress(attempt, t, h, is_shortest, solution.steps + solution.rejected);
    if (attempt.accepted()) {
      t = next;
      solution.y = attempt.y;
      observe(t, solution.y);
    }
    h = attempt.next_h;
  }
  return solution;
}

/// @}

}  // namespace tumble
