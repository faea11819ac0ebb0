// expect: wrong
// In the z component stands y for x.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  const Eigen::Vector3d arm = p - x;
  // τ = (p − x) × F
  return {arm.y() * force.z() - arm.z() * force.y(), arm.z() * force.x() - arm.x() * force.z(),
          arm.x() * force.y() - arm.y() * force.y()};
}

}  // namespace momentum
