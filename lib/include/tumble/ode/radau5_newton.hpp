#pragma once
/// @file
/// The nonlinear equations of a Radau IIA step, by simplified Newton in transformed variables.
///
///     W = T⁻¹ Z:   (Λ/h ⊗ I − I ⊗ J) ΔW = T⁻¹ F(Z) − Λ/h W
///
/// Source: Hairer & Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.8,
/// eqs. 8.4 to 8.11.

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "tumble/ode/jacobian.hpp"
#include "tumble/ode/linear_solver.hpp"
#include "tumble/ode/radau5_coefficients.hpp"

namespace tumble::detail {

/// Z₁, Z₂, Z₃ side by side.
template <OdeState State>
using Radau5Stages = Eigen::Matrix<ScalarOf<State>, State::RowsAtCompileTime, 3>;

/// Where the iteration starts: the collocation polynomial of the last step, continued into this
/// one.
/// @param last_Z, last_h of the last step; last_h = 0 if there is none
template <OdeState State>
Radau5Stages<State> continued(const Radau5Stages<State>& last_Z, ScalarOf<State> last_h,
                              const State& y, ScalarOf<State> h) {
  using C = Radau5Coefficients<ScalarOf<State>>;
  Radau5Stages<State> guess = Radau5Stages<State>::Zero(y.size(), 3);
  if (last_h == 0) return guess;
  for (int i = 0; i < 3; ++i) {
    const Vector3<ScalarOf<State>> weights = C::interpolation_weights(1 + C::c()[i] * h / last_h);
    guess.col(i) = last_Z.lazyProduct(weights) - last_Z.col(2);
  }
  return guess;
}

/// The matrices of Newton's method, factorised for one h and one Jacobian.
template <OdeState State>
class Radau5Matrices {
 public:
  using Scalar = ScalarOf<State>;
  using Complex = std::complex<Scalar>;

  Radau5Matrices() = default;
  Radau5Matrices(Scalar h, const JacobianOf<State>& J) {
    using C = Radau5Coefficients<Scalar>;
    JacobianOf<State> real = -J;
    ComplexMatrix complex = -J.template cast<Complex>();
    real.diagonal().array() += C::gamma / h;
    complex.diagonal().array() += Complex(C::alpha, C::beta) / h;
    real_.compute(real);
    complex_.compute(complex);
  }

  /// (γ/h I − J)⁻¹ b.
  State solve_real(const State& b) const { return real_.solve(b); }

  /// (Λ/h ⊗ I − I ⊗ J)⁻¹ b, with the last two columns as one complex column.
  Radau5Stages<State> solve(const Radau5Stages<State>& b) const {
    ComplexVector pair(b.rows());
    for (Eigen::Index i = 0; i < b.rows(); ++i) pair[i] = Complex(b(i, 1), b(i, 2));
    const ComplexVector solved = complex_.solve(pair);
    Radau5Stages<State> x(b.rows(), 3);
    x.col(0) = real_.solve(b.col(0));
    x.col(1) = solved.real();
    x.col(2) = solved.imag();
    return x;
  }

 private:
  static constexpr int n = State::RowsAtCompileTime;
  using ComplexMatrix = Eigen::Matrix<Complex, n, n>;
  using ComplexVector = Eigen::Matrix<Complex, n, 1>;

  LinearSolver<JacobianOf<State>> real_;
  LinearSolver<ComplexMatrix> complex_;
};

/// When to stop the iteration.
struct NewtonLimits {
  double tolerance;    ///< for the error that is left, in the norm of the problem
  int max_iterations;  ///< after which a shorter step is the better way
  double last_eta;     ///< θ/(1−θ) at the end of the last iteration: this one will be alike
};

/// What the iteration found.
template <OdeState State>
struct NewtonResult {
  Radau5Stages<State> Z;
  bool converged = false;
  bool finite = true;  ///< f had a value everywhere
  int iterations = 0;
  double rate = 0.001;  ///< θ, the factor from one correction to the next
  double eta = 1;       ///< θ/(1−θ)
};

/// T⁻¹ F(Z) − Λ/h W: what the equations still lack.
template <OdeState State, OdeRhs<State> F>
Radau5Stages<State> radau5_residual(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h,
                                    const Radau5Stages<State>& Z, const Radau5Stages<State>& W) {
  using C = Radau5Coefficients<ScalarOf<State>>;
  const Vector3<ScalarOf<State>> c = C::c();
  Radau5Stages<State> F_of_Z(y.size(), 3);
  for (int i = 0; i < 3; ++i) F_of_Z.col(i) = State(f(t + c[i] * h, State(y + Z.col(i))));

  Radau5Stages<State> residual = F_of_Z.lazyProduct(C::T_inverse().transpose());
  residual.col(0) -= C::gamma / h * W.col(0);
  residual.col(1) -= C::alpha / h * W.col(1) - C::beta / h * W.col(2);
  residual.col(2) -= C::beta / h * W.col(1) + C::alpha / h * W.col(2);
  return residual;
}

/// Solves for Z, from a guess.
/// @param norm norm(ΔW) ≤ limits.tolerance is exact enough
template <OdeState State, OdeRhs<State> F, class Norm>
NewtonResult<State> solve_radau5(F&& f, ScalarOf<State> t, const State& y, ScalarOf<State> h,
                                 const Radau5Stages<State>& guess,
                                 const Radau5Matrices<State>& matrices, const Norm& norm,
                                 const NewtonLimits& limits) {
  using C = Radau5Coefficients<ScalarOf<State>>;
  NewtonResult<State> result;
  result.Z = guess;
  result.eta = std::pow(std::max(limits.last_eta, 1e-16), 0.8);
  Radau5Stages<State> W = guess.lazyProduct(C::T_inverse().transpose());
  double last_size = 0;
  for (int k = 1; k <= limits.max_iterations; ++k) {
    const Radau5Stages<State> dW = matrices.solve(radau5_residual(f, t, y, h, result.Z, W));
    result.iterations = k;
    result.finite = dW.allFinite();
    if (!result.finite) return result;

    const double size = norm(dW);
    if (k > 1) {
      result.rate = size / last_size;
      result.eta = result.rate / (1 - result.rate);
      const int left = std::max(limits.max_iterations - k - 1, 0);
      const double predicted = result.eta * size * std::pow(result.rate, left);
      if (result.rate >= 1 || predicted > limits.tolerance) return result;
    }
    W += dW;
    result.Z = W.lazyProduct(C::T().transpose());
    last_size = size;
    result.converged = size == 0 || result.eta * size <= limits.tolerance;
    if (result.converged) return result;
  }
  return result;
}

}  // namespace tumble::detail
