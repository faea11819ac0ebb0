#pragma once
/// @file
/// Chapter 2, solvers: what is to be written, one function a file.
///
/// A solver is as good as the error it makes in the time it takes. These are the parts that such a
/// comparison is made of: how an error is measured, how a step is chosen by it, what to do where no
/// short step would be short enough, and how to see that a method does what it promises.

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "../01_particles/contract.hpp"
#include "not_implemented.hpp"

namespace solvers {

using particles::Rhs;

/// The Jacobian ∂f/∂y of a right-hand side, as a function of t and y: in row i and column j stands
/// the derivative of fᵢ by yⱼ.
using Jacobian = std::function<Eigen::MatrixXd(double t, const Eigen::VectorXd& y)>;

/// The error that is allowed: of a large number a fraction, of a small one an amount.
struct Tolerances {
  double relative;  ///< positive
  double absolute;  ///< positive, in the unit of the state
};

/// The x with A x = b, ready for use: Gaussian elimination with the largest pivot of each column.
/// @param A square; where it is singular, x is not finite
inline Eigen::VectorXd solve(Eigen::MatrixXd A, Eigen::VectorXd b) {
  const Eigen::Index n = b.size();
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = k;
    for (Eigen::Index i = k + 1; i < n; ++i)
      if (std::abs(A(i, k)) > std::abs(A(pivot, k))) pivot = i;
    for (Eigen::Index j = 0; j < n; ++j) std::swap(A(k, j), A(pivot, j));
    std::swap(b[k], b[pivot]);
    for (Eigen::Index i = k + 1; i < n; ++i) {
      const double factor = A(i, k) / A(k, k);
      for (Eigen::Index j = k; j < n; ++j) A(i, j) -= factor * A(k, j);
      b[i] -= factor * b[k];
    }
  }
  for (Eigen::Index i = n - 1; i >= 0; --i) {
    double known = 0;
    for (Eigen::Index j = i + 1; j < n; ++j) known += A(i, j) * b[j];
    b[i] = (b[i] - known) / A(i, i);
  }
  return b;
}

// == 2.1 error_norm: one number for the error of a step
/// Each component's error is measured in units of what is allowed there: the absolute tolerance,
/// plus the relative one times the component's size, which is the larger one of its sizes before
/// and after the step. Of these ratios the root mean square is taken: the root of the mean of the
/// squares. A step may be kept if it is at most 1.
/// @param error      estimated error of each component, of either sign; as many as there are in y0
///                   and y1
/// @param y0, y1     the state before and after the step; all may be empty
/// @param tolerances what is allowed
/// @return the norm, dimensionless; 0 for an empty state
double error_norm(const Eigen::VectorXd& error, const Eigen::VectorXd& y0,
                  const Eigen::VectorXd& y1, const Tolerances& tolerances);

// == 2.2 adaptive_step_size: how long the next step may be
/// That for which the error norm would come out as 1, times 0.9 for safety; but never shorter than
/// 0.2 times the step just tried, and never longer than 10 times.
/// @param h     the step just tried [s]; negative where time runs backwards, and then so is the
///              next one
/// @param error its error norm, 0 or more, also infinite: then the next step is the shortest
///              possible. So it is where the error is NaN, because something went wrong.
/// @param order q ≥ 1: the error norm of a step is proportional to |h| to the power q + 1
/// @return the next step [s]
double adaptive_step_size(double h, double error, int order);

// == 2.3 backward_euler_step: the slope at the end, which is not known yet
/// One step of the backward Euler method: y₁ with y₁ = y + h f(t + h, y₁). The equation is solved
/// by Newton's method. Where the problem is stiff, such as y' = −10⁶ y, putting y₁ back into the
/// right side again and again does not lead there.
/// @param f    right-hand side; evaluated at most 50 times
/// @param dfdy its Jacobian, which is needed anew in each round; evaluated at most 50 times
/// @param t    time at the start [s]
/// @param y    state at the start, of any size, also empty or zero. From here Newton's method finds
///             y₁ in at most 20 rounds, in all that is tried.
/// @param h    step [s]: positive, zero, or negative to go back in time
/// @return y₁, as exactly as rounding allows: the rounds may stop after a correction below 1e-8 of
///         y's size, since the next one would be about the square of that
Eigen::VectorXd backward_euler_step(const Rhs& f, const Jacobian& dfdy, double t,
                                    const Eigen::VectorXd& y, double h);

// == 2.4 observed_order: the order that a method is seen to have
/// Where error = C hᵖ, the points (log h, log error) lie on a line of slope p. Measured errors lie
/// near one: taken is the line with the smallest sum of squares of vertical distances.
/// @param h      steps, positive, in any order; two at least are different, some may be equal
/// @param errors the error at each of these steps, positive
/// @return p; negative or zero if the errors fall or stay as h grows
double observed_order(const std::vector<double>& h, const std::vector<double>& errors);

}  // namespace solvers
