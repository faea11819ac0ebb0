#include "contract.hpp"

namespace particles {

// 1.3 euler_step: follow the tangent.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 1.3 · Be judged: ./tumble check 1.3
Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  throw NotImplemented{};
}

}  // namespace particles
