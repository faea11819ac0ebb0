// expect: wrong | named Euler's method
// Half of the step is stored in an int.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd midpoint_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  const int half = static_cast<int>(h / 2);
  const Eigen::VectorXd k1 = f(t, y);
  const Eigen::VectorXd k2 = f(t + half, y + half * k1);
  // y(t + h) ≈ y + h k₂
  return y + h * k2;
}

}  // namespace particles
