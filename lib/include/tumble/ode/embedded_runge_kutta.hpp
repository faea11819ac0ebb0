#pragma once
/// @file
/// Explicit Runge–Kutta methods that estimate their own error: the same stages, weighted otherwise,
/// give a second result, and the difference tells how far the step can be trusted.
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// II.4 "Embedded Runge–Kutta Formulas".

#include "tumble/ode/adaptive_method.hpp"
#include "tumble/ode/explicit_runge_kutta.hpp"
#include "tumble/ode/step_size.hpp"

namespace tumble::detail {

/// The stages of a step and, last, f at its end.
template <class Tableau, OdeState State>
using EmbeddedStages = std::array<State, Tableau::stages + 1>;

}  // namespace tumble::detail

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// A tableau with an error estimate of order error_order from the stages and, if
/// error_needs_end, f at the end of the step.
template <class T>
concept EmbeddedTableau = ButcherTableau<T> && requires {
  { T::error_order } -> std::convertible_to<int>;
  { T::error_needs_end } -> std::convertible_to<bool>;
};

/// The method of an embedded tableau, for integrate_fixed and integrate_adaptive.
template <EmbeddedTableau Tableau>
struct EmbeddedRungeKutta : ExplicitRungeKutta<Tableau> {
  static constexpr int error_order = Tableau::error_order;

  /// Keeps f at the end of a step, which is the first stage of the next.
  template <OdeState State>
  class Stepper {
   public:
    using Scalar = ScalarOf<State>;

    Stepper(const Tolerances& tolerances, const State& dydt0) : tolerances_(tolerances) {
      k_[0] = dydt0;
    }

    /// Tries the step from y at t. k₁ = f(t, y) is known, from the last step or from the start.
    template <OdeRhs<State> F>
    Attempt<State> attempt(F&& f, Scalar t, const State& y, Scalar h) {
      EmbeddedRungeKutta::compute_stages(f, t, y, h, k_, std::make_index_sequence<stages - 1>{});
      const State y1 = EmbeddedRungeKutta::end_of_step(y, h, k_);
      if constexpr (Tableau::error_needs_end) k_[stages] = f(t + h, y1);
      Scalar error = Tableau::error(h, k_, y, y1, tolerances_);
      if constexpr (!Tableau::error_needs_end) {
        if (error <= 1) k_[stages] = f(t + h, y1);
      }
      // What f cannot say at the end of the step would be found by the next one, too late.
      if (error <= 1 && !k_[stages].allFinite()) error = std::numeric_limits<Scalar>::quiet_NaN();
      return {y1, error, next_step(h, error)};
    }

   private:
    static constexpr std::size_t stages = Tableau::stages;

    /// After a rejection the step does not grow again at once.
    Scalar next_step(Scalar h, Scalar error) {
      Scalar next_h = adaptive_step_size(h, error, error_order);
      const bool accepted = error <= 1;
      if (accepted) k_[0] = k_[stages];
      if (accepted && was_rejected_ && std::abs(next_h) > std::abs(h)) next_h = h;
      was_rejected_ = !accepted;
      return next_h;
    }

    Tolerances tolerances_;
    detail::EmbeddedStages<Tableau, State> k_;
    bool was_rejected_ = false;
  };
};

/// @}

}  // namespace tumble::runge_kutta
