// expect: wrong | may be named not a number
// The step is an auto expression of a slope that is gone.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  // y(t + h) ≈ y + h f(t, y)
  auto step = h * f(t, y);
  return y + step;
}

}  // namespace particles
