#include "contract.hpp"

namespace solvers {

// 2.3 backward_euler_step: the slope at the end, which is not known yet.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 2.3 · Be judged: ./tumble check 2.3
Eigen::VectorXd backward_euler_step(const Rhs& f, const Jacobian& dfdy, double t,
                                    const Eigen::VectorXd& y, double h) {
  throw NotImplemented{};
}

}  // namespace solvers
