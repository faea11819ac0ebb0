// expect: wrong
// q is added to its rate.
#include "contract.hpp"

namespace quaternions {

Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega) {
  const Quaternion spin(0, omega.x(), omega.y(), omega.z());
  // q̇ = ½ ⟨0, ω⟩ q
  return q + 0.5 * product(spin, q);
}

}  // namespace quaternions
