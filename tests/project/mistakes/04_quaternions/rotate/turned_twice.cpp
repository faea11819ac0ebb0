// expect: wrong
// The point is turned twice.
#include "contract.hpp"

namespace quaternions {

Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p) {
  const Quaternion point(0, p.x(), p.y(), p.z());
  // ⟨0, p′⟩ = q ⟨0, p⟩ q⁻¹
  return product(product(product(q, q), point), inverse(product(q, q))).tail<3>();
}

}  // namespace quaternions
