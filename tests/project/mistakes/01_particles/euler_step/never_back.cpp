// expect: wrong
// A negative step is taken as a positive one.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  // y(t + h) ≈ y + h f(t, y)
  return y + std::abs(h) * f(t, y);
}

}  // namespace particles
