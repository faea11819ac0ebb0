// expect: wrong | named float
// The point goes through floats.
#include "contract.hpp"

namespace quaternions {

Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p) {
  const Quaternion point(0, static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  // ⟨0, p′⟩ = q ⟨0, p⟩ q⁻¹
  return product(product(q, point), inverse(q)).tail<3>();
}

}  // namespace quaternions
