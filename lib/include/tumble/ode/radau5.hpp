#pragma once
/// @file
/// Radau IIA of order 5 with step size control: the solver for stiff problems.
///
/// The step is stable for every h where the exact solution decays, and the Jacobian and its
/// factorisations are kept for as long as Newton's method converges fast with them.
/// Source: Hairer & Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.8
/// (starting values 8.5, stopping 8.10, error estimate 8.19 and 8.20, step size 8.21 and 8.25).

#include "tumble/core/require.hpp"
#include "tumble/ode/adaptive_method.hpp"
#include "tumble/ode/radau5_newton.hpp"
#include "tumble/ode/step_size.hpp"

namespace tumble {

/// @addtogroup ode
/// @{

/// Radau IIA for integrate_adaptive<Radau5> and integrate_fixed<Radau5>. Give f its Jacobian with
/// with_jacobian() if you know it; else it is computed by finite differences.
struct Radau5 {
  static constexpr int order = 5;
  static constexpr int error_order = 3;

  /// The state one step later, with Newton's method iterated to rounding error.
  /// @throws std::runtime_error if it does not converge
  template <OdeState State, OdeRhs<State> F>
  static State step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h);

  template <OdeState State, class Tolerance = Tolerances>
  class Stepper;
};

/// What Radau5 keeps between the steps: f, its Jacobian, two factorisations and the last stages.
template <OdeState State, class Tolerance>
class Radau5::Stepper {
 public:
  using Scalar = ScalarOf<State>;

  Stepper(const Tolerance& tolerances, const State& dydt0)
      : tolerances_(tolerances), dydt_(dydt0) {}

  /// Tries the step from y at t.
  template <OdeRhs<State> F>
  runge_kutta::Attempt<State> attempt(F&& f, Scalar t, const State& y, Scalar h) {
    if (jacobian_is_needed_) update_jacobian(f, t, y, h);
    detail::NewtonResult<State> newton = solve(f, t, y, h);
    if (!newton.converged && !jacobian_is_fresh_) {
      update_jacobian(f, t, y, h);
      newton = solve(f, t, y, h);
    }
    if (!newton.converged) return no_solution(y, h, newton);

    const State y1 = y + newton.Z.col(2);
    Scalar error = estimate_error(f, t, y, y1, h, newton.Z);
    State dydt1 = dydt_;
    if (error <= 1) dydt1 = f(t + h, y1);
    if (!dydt1.allFinite()) error = std::numeric_limits<Scalar>::quiet_NaN();
    const Scalar next_h = next_step(h, error, newton);
    if (error <= 1) keep(dydt1, h, error, newton);
    is_doubtful_ = !(error <= 1);
    return {y1, error, std::copysign(std::min(std::abs(next_h), longest_), h)};
  }

  Tolerance& tolerances() { return tolerances_; }

 private:
  static constexpr int max_iterations = 7;

  template <class F>
  void update_jacobian(F&& f, Scalar t, const State& y, Scalar h) {
    J_ = detail::jacobian(f, t, y, dydt_, h, tolerances_);
    jacobian_is_needed_ = false;
    jacobian_is_fresh_ = true;
    factorised_h_ = 0;
  }

  template <class F>
  detail::NewtonResult<State> solve(F&& f, Scalar t, const State& y, Scalar h) {
    factorise(h);
    const auto norm = [&](const detail::Radau5Stages<State>& W) {
      using runge_kutta::error_norm;
      const Vector3<Scalar> norms(error_norm(State(W.col(0)), y, y, tolerances_),
                                  error_norm(State(W.col(1)), y, y, tolerances_),
                                  error_norm(State(W.col(2)), y, y, tolerances_));
      return static_cast<double>(norms.norm()) / std::sqrt(3);
    };
    constexpr auto epsilon = static_cast<double>(std::numeric_limits<Scalar>::epsilon());
    const double tolerance = std::max(10 * epsilon / tolerances_.relative,
                                      std::min(0.03, std::sqrt(tolerances_.relative)));
    return detail::solve_radau5(f, t, y, h, detail::continued(last_Z_, last_h_, y, h), matrices_,
                                norm, detail::NewtonLimits{tolerance, max_iterations, last_eta_});
  }

  /// The matrices of a step as long as this one, but for the rounding of the time, serve again.
  void factorise(Scalar h) {
    using std::abs;
    const Scalar as_long = 64 * std::sqrt(std::numeric_limits<Scalar>::epsilon());
    if (abs(h - factorised_h_) <= as_long * abs(h)) return;
    matrices_ = detail::Radau5Matrices<State>(h, J_);
    factorised_h_ = h;
  }

  /// Newton's method has failed although the Jacobian is of here and now: half the step, and for a
  /// while no more than most of it.
  runge_kutta::Attempt<State> no_solution(const State& y, Scalar h,
                                          const detail::NewtonResult<State>& newton) {
    is_doubtful_ = true;
    longest_ = Scalar(0.8) * std::abs(h);
    forget_ = Scalar(1.02);
    const Scalar error = newton.finite ? std::numeric_limits<Scalar>::infinity()
                                       : std::numeric_limits<Scalar>::quiet_NaN();
    return {y, error, h / 2};
  }

  /// The difference from an embedded formula of order 3, filtered so that stiff components do not
  /// make it too large; filtered twice where it is not trusted.
  template <class F>
  Scalar estimate_error(F&& f, Scalar t, const State& y, const State& y1, Scalar h,
                        const detail::Radau5Stages<State>& Z) const {
    using runge_kutta::error_norm;
    const State difference = Z.lazyProduct(detail::Radau5Coefficients<Scalar>::e()) / h;
    State error = matrices_.solve_real(dydt_ + difference);
    const Scalar norm = error_norm(error, y, y1, tolerances_);
    if (norm <= 1 || !is_doubtful_) return norm;
    const State dydt = f(t, State(y + error));
    error = matrices_.solve_real(dydt + difference);
    return error_norm(error, y, y1, tolerances_);
  }

  /// Shorter where Newton's method had to work, and where the error is seen to grow.
  Scalar next_step(Scalar h, Scalar error, const detail::NewtonResult<State>& newton) const {
    const Scalar effort = Scalar(2 * max_iterations + 1) /
                          static_cast<Scalar>(2 * max_iterations + newton.iterations);
    const Scalar next_h = effort * runge_kutta::adaptive_step_size(h, error, error_order);
    if (!(error <= 1) || error == 0 || last_h_ == 0) return next_h;

    const Scalar trend = h / last_h_ * std::pow(last_error_ / error, Scalar(0.25));
    const Scalar factor = std::min(trend, Scalar(1)) * next_h / h;
    const bool keep_matrices = newton.rate <= slow_rate && factor >= 1 && factor <= Scalar(1.2);
    return keep_matrices ? h : factor * h;
  }

  void keep(const State& dydt1, Scalar h, Scalar error, const detail::NewtonResult<State>& newton) {
    dydt_ = dydt1;
    last_Z_ = newton.Z;
    last_h_ = h;
    last_error_ = std::max(error, Scalar(0.01));
    last_eta_ = newton.eta;
    jacobian_is_needed_ = newton.rate > slow_rate;
    jacobian_is_fresh_ = false;
    longest_ *= forget_;
    forget_ *= forget_;
  }

  static constexpr double slow_rate = 1e-3;  // of convergence, above which J is computed anew

  Tolerance tolerances_;
  State dydt_;
  detail::JacobianOf<State> J_;
  detail::Radau5Matrices<State> matrices_;
  detail::Radau5Stages<State> last_Z_;
  Scalar factorised_h_ = 0, last_h_ = 0, last_error_ = 1;
  /// The longest step that Newton's method seems to bear, and how fast that is forgotten.
  Scalar longest_ = std::numeric_limits<Scalar>::infinity(), forget_ = 1;
  double last_eta_ = 1;
  bool jacobian_is_needed_ = true, jacobian_is_fresh_ = false;
  bool is_doubtful_ = true;  // the first step, or after a rejection
};

template <OdeState State, OdeRhs<State> F>
State Radau5::step(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h) {
  using Scalar = ScalarOf<State>;
  const State dydt = f(t, y);
  const detail::Radau5Matrices<State> matrices(h, detail::jacobian(f, t, y, dydt, h));
  const Scalar size = y.norm() + std::abs(h) * dydt.norm();
  const auto norm = [&](const detail::Radau5Stages<State>& W) {
    return size == 0 ? static_cast<double>(W.norm()) : static_cast<double>(W.norm() / size);
  };
  const double tolerance = 100 * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  const detail::Radau5Stages<State> guess = detail::Radau5Stages<State>::Zero(y.size(), 3);
  const detail::NewtonResult<State> newton = detail::solve_radau5(
      f, t, y, h, guess, matrices, norm, detail::NewtonLimits{tolerance, 50, 1});
  if (!newton.converged)
    detail::throw_error<std::runtime_error>(
        "Radau5::step: Newton's iteration does not converge from t = ", t, " with h = ", h,
        ": take a shorter step");
  return y + newton.Z.col(2);
}

/// @}

}  // namespace tumble
