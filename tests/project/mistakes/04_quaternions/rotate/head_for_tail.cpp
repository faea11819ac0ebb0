// expect: wrong
// The first three numbers are returned, the scalar among them.
#include "contract.hpp"

namespace quaternions {

Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p) {
  const Quaternion point(0, p.x(), p.y(), p.z());
  // ⟨0, p′⟩ = q ⟨0, p⟩ q⁻¹
  return product(product(q, point), inverse(q)).head<3>();
}

}  // namespace quaternions
