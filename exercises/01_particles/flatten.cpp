#include "contract.hpp"

namespace particles {

// 1.1 flatten: many particles, one state.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 1.1 · Be judged: ./tumble check 1.1
Eigen::VectorXd flatten(const std::vector<Particle>& particles) {
  throw NotImplemented{};
}

}  // namespace particles
