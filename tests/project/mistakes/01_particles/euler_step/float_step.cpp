// expect: wrong | may be named float
// The step is a float.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  // y(t + h) ≈ y + h f(t, y)
  const float step = static_cast<float>(h);
  return y + step * f(t, y);
}

}  // namespace particles
