// expect: wrong
// For a step back in time the time halfway is on the other side.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd midpoint_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  const Eigen::VectorXd k1 = f(t, y);
  const Eigen::VectorXd k2 = f(t + std::abs(h) / 2, y + h / 2 * k1);
  // y(t + h) ≈ y + h k₂
  return y + h * k2;
}

}  // namespace particles
