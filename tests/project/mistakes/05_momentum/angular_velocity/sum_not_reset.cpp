// expect: wrong
// The sum of a row goes on from the row before.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d angular_velocity(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body_inv,
                                 const Eigen::Vector3d& L) {
  // ω = R I_body⁻¹ Rᵀ L: into the body's axes, where the tensor is constant, and back.
  const Eigen::Vector3d L_body = R.transpose() * L;
  Eigen::Vector3d omega_body;
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) sum += I_body_inv(i, j) * L_body[j];
    omega_body[i] = sum;
  }
  return R * omega_body;
}

}  // namespace momentum
