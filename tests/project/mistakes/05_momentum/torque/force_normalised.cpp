// expect: wrong
// Only the direction of the force is used.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  const Eigen::Vector3d arm = p - x;
  // τ = (p − x) × F
  return rotation_matrices::skew(arm) * force.normalized();
}

}  // namespace momentum
