// expect: wrong | crashed
// The slope at the start is static: that of the first call stays.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd midpoint_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  static const Eigen::VectorXd k1 = f(t, y);
  const Eigen::VectorXd k2 = f(t + h / 2, y + h / 2 * k1);
  // y(t + h) ≈ y + h k₂
  return y + h * k2;
}

}  // namespace particles
