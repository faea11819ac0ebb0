#include "contract.hpp"

namespace particles {

// 1.2 dydt: what moves the particles.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 1.2 · Be judged: ./tumble check 1.2
Eigen::VectorXd dydt(const System& system, double t, const Eigen::VectorXd& y) {
  throw NotImplemented{};
}

}  // namespace particles
