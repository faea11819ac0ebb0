#include "contract.hpp"

namespace particles {

// 1.5 rk4_step: four slopes for one step.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 1.5 · Be judged: ./tumble check 1.5
Eigen::VectorXd rk4_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  throw NotImplemented{};
}

}  // namespace particles
