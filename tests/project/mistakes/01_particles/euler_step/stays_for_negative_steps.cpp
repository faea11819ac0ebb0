// expect: wrong
// For a negative step the state is returned as it is.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  // y(t + h) ≈ y + h f(t, y)
  if (h <= 0) return y;
  return y + h * f(t, y);
}

}  // namespace particles
