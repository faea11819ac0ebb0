// expect: wrong | named not a number | may be named never set
// The z component was never set.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  const Eigen::Vector3d arm = p - x;
  // τ = (p − x) × F
  Eigen::Vector3d tau;
  tau[0] = arm.y() * force.z() - arm.z() * force.y();
  tau[1] = arm.z() * force.x() - arm.x() * force.z();
  return tau;
}

}  // namespace momentum
