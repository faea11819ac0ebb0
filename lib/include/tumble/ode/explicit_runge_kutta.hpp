#pragma once
/// @file
/// One step of the explicit Runge–Kutta method of a tableau.
///
///     kᵢ = f(t + cᵢ h, y + h Σ_{j<i} aᵢⱼ kⱼ),   y(t + h) = y + h Σ bᵢ kᵢ
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed.
/// (1993), definition II.1.1.

#include "tumble/ode/butcher_tableau.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// The method of a tableau. With `struct Heun { … c, a, b … }`, ExplicitRungeKutta<Heun> is a
/// method for integrate_fixed.
template <ButcherTableau Tableau>
struct ExplicitRungeKutta {
  static constexpr int order = Tableau::order;
  static constexpr std::size_t stages = Tableau::stages;

  /// The state one step later.
  template <OdeState State, OdeRhs<State> F>
  static State step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
    std::array<State, stages> k;
    k[0] = f(t, y);
    compute_stages(f, t, y, h, k, std::make_index_sequence<stages - 1>{});
    return end_of_step(y, h, k);
  }

 protected:
  /// Fills k₂ … kₛ; k₁ = f(t, y) is there already. k may be longer than that.
  template <class F, OdeState State, std::size_t n, std::size_t... i>
  static void compute_stages(F& f, ScalarOf<State> t, const State& y, ScalarOf<State> h,
                             std::array<State, n>& k, std::index_sequence<i...>) {
    ((k[i + 1] = stage<i + 1>(f, t, y, h, k)), ...);
  }

  /// y + h Σ bᵢ kᵢ.
  template <OdeState State, std::size_t n>
  static State end_of_step(const State& y, ScalarOf<State> h, const std::array<State, n>& k) {
    return detail::advance<detail::StepWeights<Tableau>, stages>(y, h, k);
  }

 private:
  template <std::size_t i, class F, OdeState State, std::size_t n>
  static State stage(F& f, ScalarOf<State> t, const State& y, ScalarOf<State> h,
                     const std::array<State, n>& k) {
    const State y_i = detail::advance<detail::StageWeights<Tableau, i>, i>(y, h, k);
    return f(t + static_cast<ScalarOf<State>>(Tableau::c[i]) * h, y_i);
  }
};

/// @}

}  // namespace tumble::runge_kutta
