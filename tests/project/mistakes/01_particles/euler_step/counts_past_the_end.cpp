// expect: crashed
// The loop runs to the size and not below it.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  // y(t + h) ≈ y + h f(t, y)
  const Eigen::VectorXd slope = f(t, y);
  Eigen::VectorXd next = y;
  for (Eigen::Index i = 0; i <= y.size(); ++i) next[i] += h * slope[i];
  return next;
}

}  // namespace particles
