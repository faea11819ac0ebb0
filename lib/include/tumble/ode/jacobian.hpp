#pragma once
/// @file
/// The Jacobian ∂f/∂y, which the implicit methods need: from the user, or by finite differences.
///
///     ∂f/∂yⱼ ≈ (f(t, y + δ eⱼ) − f(t, y)) / δ,   δ = √ε max(|yⱼ|, |h fⱼ|)
///
/// δ is √ε of a typical size, here of yⱼ or of how far it moves in a step of h: Dennis & Schnabel,
/// "Numerical Methods for Unconstrained Optimization and Nonlinear Equations" (1983), 5.4.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tumble/core/require.hpp"
#include "tumble/ode/rhs.hpp"
#include "tumble/ode/tolerances.hpp"

namespace tumble {

/// @addtogroup ode
/// @{

namespace detail {

/// n×n for a state of n components.
template <OdeState State>
using JacobianOf =
    Eigen::Matrix<ScalarOf<State>, State::RowsAtCompileTime, State::RowsAtCompileTime>;

/// A right-hand side that has its Jacobian too, as f.jacobian(t, y).
template <class F, class State>
concept KnowsJacobian = OdeRhs<F, State> && requires(F& f, ScalarOf<State> t, const State& y) {
  { f.jacobian(t, y) } -> std::convertible_to<JacobianOf<State>>;
};

/// A right-hand side and its Jacobian, made of two callables by with_jacobian().
template <class F, class Jacobian>
class RhsWithJacobian {
 public:
  RhsWithJacobian(F f, Jacobian jacobian) : f_(std::move(f)), jacobian_(std::move(jacobian)) {}

  template <OdeState State>
  State operator()(ScalarOf<State> t, const State& y) const {
    return f_(t, y);
  }

  template <OdeState State>
  JacobianOf<State> jacobian(ScalarOf<State> t, const State& y) const {
    return jacobian_(t, y);
  }

 private:
  F f_;
  Jacobian jacobian_;
};

}  // namespace detail

/// f with the Jacobian that jacobian(t, y) computes, for Radau5 and BackwardEuler.
template <class F, class Jacobian>
detail::RhsWithJacobian<F, Jacobian> with_jacobian(F f, Jacobian jacobian) {
  return {std::move(f), std::move(jacobian)};
}

namespace detail {

/// What is small for each component, where it is at rest at zero: √ε of the largest. Solvers find
/// others of this name beside tolerances that know more of sizes.
/// @param root √ε
template <OdeState State>
State small_sizes(const State& size, ScalarOf<State> root, const Tolerances&) {
  return State::Constant(size.size(), root * size.template lpNorm<Eigen::Infinity>());
}

/// ∂f/∂y by one-sided differences: one evaluation of f for each component of y.
/// @param dydt f(t, y)
/// @param h    the step that it is for
template <OdeState State, OdeRhs<State> F, class Tolerance = Tolerances>
JacobianOf<State> finite_difference_jacobian(F&& f, ScalarOf<State> t, const State& y,
                                             const State& dydt, ScalarOf<State> h,
                                             const Tolerance& tolerance = {}) {
  using std::max, std::sqrt;
  using Scalar = ScalarOf<State>;
  const Scalar root = sqrt(std::numeric_limits<Scalar>::epsilon());
  const State size = y.cwiseAbs().cwiseMax(State(h * dydt).cwiseAbs());
  const State least = small_sizes(size, root, tolerance);
  JacobianOf<State> J(y.size(), y.size());
  State shifted = y;
  for (Eigen::Index j = 0; j < y.size(); ++j) {
    shifted[j] = y[j] + root * (least[j] > 0 ? max(size[j], least[j]) : Scalar(1));
    const Scalar delta = shifted[j] - y[j];  // what was really added
    const State slope = f(t, shifted);
    J.col(j) = (slope - dydt) / delta;
    shifted[j] = y[j];
  }
  return J;
}

/// ∂f/∂y, from f.jacobian(t, y) where f has it, else by finite differences.
/// @param dydt f(t, y)
/// @param h    the step that it is for
/// @throws std::invalid_argument if f.jacobian gives a matrix of another size
template <OdeState State, OdeRhs<State> F, class Tolerance = Tolerances>
JacobianOf<State> jacobian(F&& f, ScalarOf<State> t, const State& y, const State& dydt,
                           ScalarOf<State> h, const Tolerance& tolerance = {}) {
  if constexpr (KnowsJacobian<F, State>) {
    const JacobianOf<State> J = f.jacobian(t, y);
    require(J.rows() == y.size() && J.cols() == y.size(), "jacobian: ", J.rows(), " x ", J.cols(),
            ", but the state has ", y.size(), " components");
    return J;
  } else {
    return finite_difference_jacobian(f, t, y, dydt, h, tolerance);
  }
}

}  // namespace detail

/// @}

}  // namespace tumble
