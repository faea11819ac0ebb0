// expect: wrong
// Only the direction of omega is used.
#include "contract.hpp"

namespace quaternions {

Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega) {
  const Quaternion spin(0, omega.normalized().x(), omega.normalized().y(), omega.normalized().z());
  // q̇ = ½ ⟨0, ω⟩ q
  return 0.5 * product(spin, q);
}

}  // namespace quaternions
