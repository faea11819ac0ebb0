// expect: wrong
// The conjugate of q is taken.
#include "contract.hpp"

namespace quaternions {

Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega) {
  const Quaternion spin(0, omega.x(), omega.y(), omega.z());
  // q̇ = ½ ⟨0, ω⟩ q
  return 0.5 * product(spin, Quaternion(q[0], -q[1], -q[2], -q[3]));
}

}  // namespace quaternions
