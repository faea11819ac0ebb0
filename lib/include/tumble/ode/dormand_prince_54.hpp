#pragma once
/// @file
/// The 5(4) pair of Dormand and Prince: six evaluations a step, the seventh is the
/// next step's first.
///
/// The step is of order 5; the difference from the embedded result of order 4 is the error
/// estimate. Source: Dormand & Prince, "A family of embedded Runge–Kutta formulae", J. Comput.
/// Appl. Math. 6 (1980), table 2; Hairer, Nørsett & Wanner, "Solving Ordinary Differential
/// Equations I", 2nd ed. (1993), table II.5.2.

#include "tumble/ode/embedded_runge_kutta.hpp"

namespace tumble {

/// @addtogroup ode
/// @{

namespace detail {

/// The coefficients; the seventh stage, which is f at the end of the step, is not in a.
struct DormandPrince54Tableau {
  static constexpr std::size_t stages = 6;
  static constexpr int order = 5;
  static constexpr int error_order = 4;
  static constexpr bool error_needs_end = true;

  // clang-format off
  static constexpr runge_kutta::Weights<6> c = {0, 1.L / 5, 3.L / 10, 4.L / 5, 8.L / 9, 1};
  static constexpr std::array<runge_kutta::Weights<6>, 6> a = {{
      {},
      {1.L / 5},
      {3.L / 40, 9.L / 40},
      {44.L / 45, -56.L / 15, 32.L / 9},
      {19372.L / 6561, -25360.L / 2187, 64448.L / 6561, -212.L / 729},
      {9017.L / 3168, -355.L / 33, 46732.L / 5247, 49.L / 176, -5103.L / 18656}}};
  static constexpr runge_kutta::Weights<6> b = {
      35.L / 384, 0, 500.L / 1113, 125.L / 192, -2187.L / 6784, 11.L / 84};
  // clang-format on

  /// b − b̂ with the b̂ of order 4, the last weight for f at the end.
  struct ErrorWeights {
    static constexpr runge_kutta::Weights<7> weights = {
        71.L / 57600, 0, -71.L / 16695, 71.L / 1920, -17253.L / 339200, 22.L / 525, -1.L / 40};
  };

  /// The norm of the difference between the two results.
  template <OdeState State, class Tolerance>
  static ScalarOf<State> error(ScalarOf<State> h, const std::array<State, 7>& k, const State& y0,
                               const State& y1, const Tolerance& tolerances) {
    using runge_kutta::error_norm;
    return error_norm(weighted_difference<ErrorWeights>(h, k), y0, y1, tolerances);
  }
};

}  // namespace detail

/// The method for everyday tolerances, 1e-3 to 1e-8, of problems that are not stiff.
using DormandPrince54 = runge_kutta::EmbeddedRungeKutta<detail::DormandPrince54Tableau>;

/// @}

}  // namespace tumble
