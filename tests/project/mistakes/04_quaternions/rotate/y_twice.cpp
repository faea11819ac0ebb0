// expect: wrong
// The point has y in the place of z.
#include "contract.hpp"

namespace quaternions {

Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p) {
  const Quaternion point(0, p.x(), p.y(), p.y());
  // ⟨0, p′⟩ = q ⟨0, p⟩ q⁻¹
  return product(product(q, point), inverse(q)).tail<3>();
}

}  // namespace quaternions
