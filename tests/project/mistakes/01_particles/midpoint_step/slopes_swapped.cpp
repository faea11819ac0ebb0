// expect: wrong
// The first slope is used for the whole step, the second is not.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd midpoint_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  const Eigen::VectorXd k1 = f(t, y);
  const Eigen::VectorXd k2 = f(t + h / 2, y + h / 2 * k1);
  // y(t + h) ≈ y + h k₂
  return y + h * (2 * k2 - k1);
}

}  // namespace particles
