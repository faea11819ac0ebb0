#include "contract.hpp"

namespace momentum {

// 5.5 angular_velocity: from L to ω.
// contract.hpp says what to write. Stuck? ./tumble hint 5.5 · Done? ./tumble check 5.5
Eigen::Vector3d angular_velocity(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body_inv,
                                 const Eigen::Vector3d& L) {
  throw NotImplemented{};
}

}  // namespace momentum
