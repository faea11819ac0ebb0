// expect: wrong | passed by luck
// The torque is an auto expression of a matrix that is gone.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  const Eigen::Vector3d arm = p - x;
  // τ = (p − x) × F
  const auto tau = rotation_matrices::skew(arm) * force;
  return tau;
}

}  // namespace momentum
