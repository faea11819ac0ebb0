// expect: wrong | passed by luck
// The point is an auto expression of a product that is gone.
#include "contract.hpp"

namespace quaternions {

Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p) {
  const Quaternion point(0, p.x(), p.y(), p.z());
  // ⟨0, p′⟩ = q ⟨0, p⟩ q⁻¹
  const auto turned = product(product(q, point), inverse(q)).tail<3>();
  return turned;
}

}  // namespace quaternions
