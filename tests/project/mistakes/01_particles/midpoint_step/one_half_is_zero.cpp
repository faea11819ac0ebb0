// expect: wrong | named whole-number division
// 1/2 is 0: both slopes are at the start.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd midpoint_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  const Eigen::VectorXd k1 = f(t, y);
  const Eigen::VectorXd k2 = f(t + 1 / 2 * h, y + 1 / 2 * h * k1);
  // y(t + h) ≈ y + h k₂
  return y + h * k2;
}

}  // namespace particles
