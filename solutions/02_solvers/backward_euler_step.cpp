#include <algorithm>

#include "contract.hpp"

namespace solvers {

Eigen::VectorXd backward_euler_step(const Rhs& f, const Jacobian& dfdy, double t,
                                    const Eigen::VectorXd& y, double h) {
  // Each round squares what is left, so that after a correction below this nothing is left.
  constexpr double small_correction = 1e-10;
  constexpr int enough = 25;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(y.size(), y.size());
  Eigen::VectorXd y1 = y;
  for (int round = 0; round < enough; ++round) {
    // (1 − h ∂f/∂y) Δ = y + h f(t + h, y₁) − y₁
    const Eigen::VectorXd residual = y + h * f(t + h, y1) - y1;
    const Eigen::VectorXd correction = solve(identity - h * dfdy(t + h, y1), residual);
    y1 += correction;
    if (correction.norm() <= small_correction * std::max(y.norm(), y1.norm())) break;
  }
  return y1;
}

}  // namespace solvers
