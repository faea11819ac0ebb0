// expect: wrong | named whole-number division
// 1/6 is 0: nothing moves.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd rk4_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  const Eigen::VectorXd k1 = f(t, y);
  const Eigen::VectorXd k2 = f(t + h / 2, y + h / 2 * k1);
  const Eigen::VectorXd k3 = f(t + h / 2, y + h / 2 * k2);
  const Eigen::VectorXd k4 = f(t + h, y + h * k3);
  // y(t + h) ≈ y + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄)
  return y + h * (1 / 6) * (k1 + 2 * k2 + 2 * k3 + k4);
}

}  // namespace particles
