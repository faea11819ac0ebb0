// expect: wrong | passed by luck
// The rate is an auto expression of a product that is gone.
#include "contract.hpp"

namespace quaternions {

Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega) {
  const Quaternion spin(0, omega.x(), omega.y(), omega.z());
  // q̇ = ½ ⟨0, ω⟩ q
  const auto rate = 0.5 * product(spin, q);
  return rate;
}

}  // namespace quaternions
