// expect: wrong | may be named not a number
// The state halfway is an auto expression of a slope that is gone.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd midpoint_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  const auto half = y + h / 2 * f(t, y);
  const Eigen::VectorXd k2 = f(t + h / 2, half);
  // y(t + h) ≈ y + h k₂
  return y + h * k2;
}

}  // namespace particles
