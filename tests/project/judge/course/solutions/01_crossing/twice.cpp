#include "contract.hpp"

namespace crossing {

Eigen::VectorXd twice(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  const Eigen::VectorXd once = f(t, y);
  return f(t + h, once);
}

}  // namespace crossing
