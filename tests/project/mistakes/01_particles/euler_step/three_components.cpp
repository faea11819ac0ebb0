// expect: crashed
// The slope is a vector of three numbers.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  // y(t + h) ≈ y + h f(t, y)
  const Eigen::Vector3d slope = f(t, y);
  return y + h * slope;
}

}  // namespace particles
