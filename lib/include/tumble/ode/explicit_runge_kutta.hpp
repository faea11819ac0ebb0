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
    compute_stages(f, t, y, h, k);
    return end_of_step(y, h, k);
  }

 protected:
  /// Fills k₂ … kₛ; k₁ = f(t, y) is there already. k may be longer than that.
  ///
  /// This is a loop although each stage has a sum of its own: so f is in one place, where it is
  /// inlined, and is not called through memory.
  template <class F, OdeState State, std::size_t n>
  static TUMBLE_INLINE void compute_stages(F& f, ScalarOf<State> t, const State& y,
                                           ScalarOf<State> h, std::array<State, n>& k) {
    for (std::size_t i = 1; i < stages; ++i)
      detail::evaluate_into(k[i], f, t + static_cast<ScalarOf<State>>(Tableau::c[i]) * h,
                            place_of_stage(i, y, h, k, std::make_index_sequence<stages - 1>{}));
  }

  /// y + h Σ bᵢ kᵢ.
  template <OdeState State, std::size_t n>
  static TUMBLE_INLINE State end_of_step(const State& y, ScalarOf<State> h,
                                         const std::array<State, n>& k) {
    return detail::advance<detail::StepWeights<Tableau>, stages>(y, h, k);
  }

 private:
  /// y + h Σ aᵢⱼ kⱼ, for stage i of 1 … stages − 1.
  template <OdeState State, std::size_t n, std::size_t... j>
  static TUMBLE_INLINE State place_of_stage(std::size_t i, const State& y, ScalarOf<State> h,
                                            const std::array<State, n>& k,
                                            std::index_sequence<j...>) {
    State place(y.size(), 1);
    const auto advance = [&]<std::size_t stage>() {
      detail::advance_into<detail::StageWeights<Tableau, stage>, stage>(place, y, h, k);
      return true;
    };
    static_cast<void>(((i == j + 1 && advance.template operator()<j + 1>()) || ...));
    return place;
  }
};

/// @}

}  // namespace tumble::runge_kutta
