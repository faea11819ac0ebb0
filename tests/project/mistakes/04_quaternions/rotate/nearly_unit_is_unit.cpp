// expect: wrong
// Near length 1 the conjugate is taken for the inverse.
#include "contract.hpp"

namespace quaternions {

Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p) {
  const Quaternion conjugate(q[0], -q[1], -q[2], -q[3]);
  const bool unit = std::abs(q.norm() - 1) < 1e-2;
  const Quaternion point(0, p.x(), p.y(), p.z());
  // ⟨0, p′⟩ = q ⟨0, p⟩ q⁻¹
  return product(product(q, point), unit ? conjugate : inverse(q)).tail<3>();
}

}  // namespace quaternions
