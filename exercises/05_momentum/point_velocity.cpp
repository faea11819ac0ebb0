#include "contract.hpp"

namespace momentum {

// 5.2 point_velocity: how fast a point of a body moves.
// contract.hpp says what to write. Stuck? ./tumble hint 5.2 · Done? ./tumble check 5.2
Eigen::Vector3d point_velocity(const Eigen::Vector3d& x, const Eigen::Matrix3d& R,
                               const Eigen::Vector3d& v, const Eigen::Vector3d& omega,
                               const Eigen::Vector3d& p_body) {
  throw NotImplemented{};
}

}  // namespace momentum
