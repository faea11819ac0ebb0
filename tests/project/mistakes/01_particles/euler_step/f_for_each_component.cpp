// expect: wrong | named evaluated too often
// The right-hand side is evaluated anew for each component.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  // y(t + h) ≈ y + h f(t, y)
  Eigen::VectorXd next = y;
  for (Eigen::Index i = 0; i < y.size(); ++i) next[i] = y[i] + h * f(t, y)[i];
  return next;
}

}  // namespace particles
