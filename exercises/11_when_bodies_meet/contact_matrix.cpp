#include "contract.hpp"

namespace when_bodies_meet {

// 11.4 contact_matrix: how a point responds to an impulse.
// contract.hpp says what to write. Stuck? ./tumble hint 11.4 · Done? ./tumble check 11.4
Eigen::Matrix3d contact_matrix(const Body& body, const State& state, const Eigen::Vector3d& point) {
  throw NotImplemented{};
}

}  // namespace when_bodies_meet
