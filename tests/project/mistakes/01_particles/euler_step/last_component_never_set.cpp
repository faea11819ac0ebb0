// expect: wrong | named not a number | may be named never set
// The loop ends one component early.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  // y(t + h) ≈ y + h f(t, y)
  const Eigen::VectorXd slope = f(t, y);
  Eigen::VectorXd next(y.size());
  for (Eigen::Index i = 0; i < y.size() - 1; ++i) next[i] = y[i] + h * slope[i];
  return next;
}

}  // namespace particles
