// expect: wrong
// The scalar part is set to 0, as that of omega.
#include "contract.hpp"

namespace quaternions {

Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega) {
  const Quaternion spin(0, omega.x(), omega.y(), omega.z());
  // q̇ = ½ ⟨0, ω⟩ q
  Quaternion rate = 0.5 * product(spin, q);
  rate[0] = 0;
  return rate;
}

}  // namespace quaternions
