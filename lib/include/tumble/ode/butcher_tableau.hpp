#pragma once
/// @file
/// The coefficients of an explicit Runge–Kutta method.
///
///     kᵢ = f(t + cᵢ h, y + h Σ_{j<i} aᵢⱼ kⱼ),   y(t + h) = y + h Σ bᵢ kᵢ
///
/// A tableau is a type, so that the compiler knows every number in it and a zero costs nothing.
/// Source: Butcher (1964); Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I",
/// 2nd ed. (1993), definition II.1.1.

#include <array>
#include <concepts>
#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

#include "tumble/core/inline.hpp"
#include "tumble/ode/rhs.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// Coefficients of one sum over the stages, in the longest format there is.
template <std::size_t n>
using Weights = std::array<long double, n>;

/// Static members `stages`, `order`, `c`, `a` (below the diagonal) and `b`.
template <class T>
concept ButcherTableau = requires {
  { T::stages } -> std::convertible_to<std::size_t>;
  { T::order } -> std::convertible_to<int>;
  { T::c } -> std::convertible_to<Weights<T::stages>>;
  { T::a } -> std::convertible_to<std::array<Weights<T::stages>, T::stages>>;
  { T::b } -> std::convertible_to<Weights<T::stages>>;
};

/// @}

}  // namespace tumble::runge_kutta

namespace tumble::detail {

/// Row i of a as a type of its own.
template <runge_kutta::ButcherTableau Tableau, std::size_t i>
struct StageWeights {
  static constexpr auto weights = Tableau::a[i];
};

/// b as a type of its own.
template <runge_kutta::ButcherTableau Tableau>
struct StepWeights {
  static constexpr auto weights = Tableau::b;
};

/// sum + wⱼ k, and nothing at all where wⱼ is zero.
template <class Row, std::size_t j, class Scalar>
TUMBLE_INLINE Scalar add_weighted(const Scalar& sum, const Scalar& k) {
  if constexpr (Row::weights[j] == 0)
    return sum;
  else
    return sum + static_cast<Scalar>(Row::weights[j]) * k;
}

/// Component i of Σⱼ wⱼ kⱼ, over the first stages k.
template <class Row, OdeState State, std::size_t n, std::size_t... j>
TUMBLE_INLINE ScalarOf<State> weighted_sum(const std::array<State, n>& k, Eigen::Index i,
                                           std::index_sequence<j...>) {
  ScalarOf<State> sum(0);
  ((sum = add_weighted<Row, j>(sum, k[j][i])), ...);
  return sum;
}

/// result = y + h Σⱼ wⱼ kⱼ in one pass, over the first `terms` stages k.
template <class Row, std::size_t terms, OdeState State, std::size_t n>
TUMBLE_INLINE void advance_into(State& result, const State& y, ScalarOf<State> h,
                                const std::array<State, n>& k) {
  for (Eigen::Index i = 0; i < y.size(); ++i)
    result[i] = y[i] + h * weighted_sum<Row>(k, i, std::make_index_sequence<terms>{});
}

/// y + h Σⱼ wⱼ kⱼ.
template <class Row, std::size_t terms, OdeState State, std::size_t n>
TUMBLE_INLINE State advance(const State& y, ScalarOf<State> h, const std::array<State, n>& k) {
  State result(y.size(), 1);
  advance_into<Row, terms>(result, y, h, k);
  return result;
}

/// k = f(t, y); a state on the stack is made in its place, not copied to it.
template <OdeState State, class F>
TUMBLE_INLINE void evaluate_into(State& k, F& f, ScalarOf<State> t, const State& y) {
  if constexpr (std::is_trivially_destructible_v<State>)
    ::new (static_cast<void*>(&k)) State(f(t, y));
  else
    k = f(t, y);
}

/// h Σⱼ wⱼ kⱼ over all the stages that Row weighs: an error estimate.
template <class Row, OdeState State, std::size_t n>
TUMBLE_INLINE State weighted_difference(ScalarOf<State> h, const std::array<State, n>& k) {
  State result(k[0].size(), 1);
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result[i] = h * weighted_sum<Row>(k, i, std::make_index_sequence<Row::weights.size()>{});
  return result;
}

}  // namespace tumble::detail
