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
  /// @tparam Tolerance what its error_norm() is measured by
  template <OdeState State, class Tolerance = Tolerances>
  class Stepper {
   public:
    using Scalar = ScalarOf<State>;

    Stepper(const Tolerance& tolerances, const State& dydt0) : tolerances_(tolerances) {
      k_[stages] = dydt0;
    }

    /// Tries the step from y at t. k₁ = f(t, y) is known, from the last step or from the start.
    template <OdeRhs<State> F>
    Attempt<State> attempt(F&& f, Scalar t, const State& y, Scalar h) {
      if (was_accepted_) k_[0] = k_[stages];
      EmbeddedRungeKutta::compute_stages(f, t, y, h, k_);
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

    /// The stages of the last attempt and, if it was accepted, f at its end.
    const detail::EmbeddedStages<Tableau, State>& stages_of_step() const { return k_; }
    Tolerance& tolerances() { return tolerances_; }

    /// |h λ| of the fastest part of f that the last step, from y to y1, has met. Beyond about 6 the
    /// steps of Dop853 are as short as stability demands, not accuracy.
    /// Source: Hairer & Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.2,
    /// eq. 2.9.
    Scalar stiffness(const State& y, const State& y1, Scalar h) const {
      static_assert(Tableau::c[stages - 1] == 1, "compares two evaluations at the end of the step");
      using LastStage = detail::StageWeights<Tableau, stages - 1>;
      const State other = detail::advance<LastStage, stages - 1>(y, h, k_);
      using std::abs;
      return abs(h) * (k_[stages] - k_[stages - 1]).norm() / (y1 - other).norm();
    }

   private:
    static constexpr std::size_t stages = Tableau::stages;

    /// After a rejection the step does not grow again at once.
    Scalar next_step(Scalar h, Scalar error) {
      using std::abs;
      Scalar next_h = adaptive_step_size(h, error, error_order);
      const bool accepted = error <= 1;
      if (accepted && !was_accepted_ && abs(next_h) > abs(h)) next_h = h;
      was_accepted_ = accepted;
      return next_h;
    }

    Tolerance tolerances_;
    detail::EmbeddedStages<Tableau, State> k_;
    bool was_accepted_ = true;
  };
};

/// @}

}  // namespace tumble::runge_kutta
