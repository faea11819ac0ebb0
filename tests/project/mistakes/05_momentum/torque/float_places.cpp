// expect: wrong | named float
// The places are floats before they are subtracted.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  const Eigen::Vector3d arm = (p.cast<float>() - x.cast<float>()).cast<double>();
  // τ = (p − x) × F
  return rotation_matrices::skew(arm) * force;
}

}  // namespace momentum
