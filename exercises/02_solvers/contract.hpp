#pragma once
/// @file
/// Chapter 2, solvers: what you write, one function per file.
///
/// A solver is as good as the error it makes in the time it takes. Here you measure the error of a
/// step, choose the next step by it, take a step where no explicit one would be short enough, and
/// see whether a method keeps what it promises.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises, those of
/// chapter 1 as well. The judge supplies correct ones, even where yours don't pass yet. Of Eigen
/// there is no other part, so no inverse() and no decomposition: for linear equations you have
/// solve(), below.

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "../01_particles/contract.hpp"
#include "not_implemented.hpp"

namespace solvers {

using particles::Rhs;

/// The Jacobian ∂f/∂y of a right-hand side, as a function of t and y: row i and column j hold the
/// derivative of fᵢ with respect to yⱼ.
using Jacobian = std::function<Eigen::MatrixXd(double t, const Eigen::VectorXd& y)>;

/// The error that you allow: a fraction of a large number, a fixed amount of a small one.
struct Tolerances {
  double relative;  ///< positive
  double absolute;  ///< positive, in the unit of the state
};

/// The x with A x = b, ready for you to use: Gaussian elimination with the largest pivot of each
/// column.
/// @param A square; if it is singular, x is not finite
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
/// Measure each component's error in units of what you allow there: the absolute tolerance, plus
/// the relative one times the component's size. Its size is the larger one of those before and
/// after the step. Then take the root mean square of these ratios: the root of the mean of their
/// squares. A solver keeps the step if this norm is at most 1.
/// @param error      estimated error of each component, of either sign; as many as there are in y0
///                   and y1
/// @param y0, y1     the state before and after the step; all may be empty
/// @param tolerances what is allowed
/// @return the norm, dimensionless; 0 for an empty state
double error_norm(const Eigen::VectorXd& error, const Eigen::VectorXd& y0,
                  const Eigen::VectorXd& y1, const Tolerances& tolerances);

// == 2.2 adaptive_step_size: how long the next step may be
/// Take the step for which the error norm would be 1, times 0.9 for safety; but none shorter than
/// 0.2 times the step just tried, and none longer than 10 times.
/// @param h     the step just tried [s]; if time runs backwards it is negative, and then so is the
///              next one
/// @param error its error norm, 0 or more. If it is infinite, or NaN because something went wrong,
///              the next step is the shortest possible
/// @param order q ≥ 1, the order of the worse one of the two results: the error norm of a step is
///              proportional to |h| to the power q + 1
/// @return the next step [s]
double adaptive_step_size(double h, double error, int order);

// == 2.3 backward_euler_step: the slope at the end, which is not known yet
/// One step of the backward Euler method: the y₁ with y₁ = y + h f(t + h, y₁). Solve this equation
/// by Newton's method. Fixed-point iteration, which puts y₁ back into the right side again and
/// again, does not lead there if the problem is stiff, such as y' = −10⁶ y.
/// @param f    right-hand side; evaluate it at most 50 times
/// @param dfdy its Jacobian, which you need anew in each iteration; evaluate it at most 50 times
/// @param t    time at the start [s]
/// @param y    state at the start, of any length, also empty, and in any unit: its numbers may be
///             zero, or as small as 1e-30, or as large as 1e30. In all that the judge tries,
///             Newton's method finds y₁ from y in at most 20 iterations; sometimes it takes more
///             than 10. So there is always a solution. If the equation has several, y₁ is the one
///             that it finds
/// @param h    step [s]: positive, zero, or negative to go back in time
/// @return y₁, as exactly as rounding allows: you may stop after a correction below 1e-8 of the
///         size of y or y₁, whichever is larger, since the next one would be about the square of
///         that. The size of a state is the largest absolute value of its components
Eigen::VectorXd backward_euler_step(const Rhs& f, const Jacobian& dfdy, double t,
                                    const Eigen::VectorXd& y, double h);

// == 2.4 observed_order: the order that a method is seen to have
/// If error = C hᵖ, the points (log h, log error) lie on a line of slope p. Measured errors lie
/// near one: take the line with the smallest sum of squares of vertical distances.
/// @param h      steps, positive, in any order; at least two are different, some may be equal
/// @param errors the error at each of these steps, positive
/// @return p; zero if the errors stay the same as h grows, negative if they fall
double observed_order(const std::vector<double>& h, const std::vector<double>& errors);

}  // namespace solvers
