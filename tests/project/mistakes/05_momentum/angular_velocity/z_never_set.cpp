// expect: wrong | named not a number | may be named never set
// The loop ends at the second component.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d angular_velocity(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body_inv,
                                 const Eigen::Vector3d& L) {
  // ω = R I_body⁻¹ Rᵀ L: into the body's axes, where the tensor is constant, and back.
  const Eigen::Vector3d L_body = R.transpose() * L;
  Eigen::Vector3d omega_body;
  for (int i = 0; i < 2; ++i) omega_body[i] = I_body_inv.row(i).dot(L_body);
  return R * omega_body;
}

}  // namespace momentum
