// expect: wrong
// omega has z in the place of y.
#include "contract.hpp"

namespace quaternions {

Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega) {
  const Quaternion spin(0, omega.x(), omega.z(), omega.z());
  // q̇ = ½ ⟨0, ω⟩ q
  return 0.5 * product(spin, q);
}

}  // namespace quaternions
