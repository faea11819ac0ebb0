// expect: wrong | named whole-number division
// 1/2 is 0.
#include "contract.hpp"

namespace quaternions {

Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega) {
  const Quaternion spin(0, omega.x(), omega.y(), omega.z());
  // q̇ = ½ ⟨0, ω⟩ q
  return 1 / 2 * product(spin, q);
}

}  // namespace quaternions
