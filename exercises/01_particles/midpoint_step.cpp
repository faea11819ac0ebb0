#include "contract.hpp"

namespace particles {

// 1.4 midpoint_step: look halfway, then go.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 1.4 · Be judged: ./tumble check 1.4
Eigen::VectorXd midpoint_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  throw NotImplemented{};
}

}  // namespace particles
