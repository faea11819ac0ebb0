#include "contract.hpp"

namespace particles {

// 1.2 dydt: what moves the particles.
// contract.hpp says what to write. Stuck? ./tumble hint 1.2 · Done? ./tumble check 1.2
Eigen::VectorXd dydt(const System& system, double t, const Eigen::VectorXd& y) {
  throw NotImplemented{};
}

}  // namespace particles
