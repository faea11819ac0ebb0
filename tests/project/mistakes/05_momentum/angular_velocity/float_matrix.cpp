// expect: wrong | named float | named not a number
// The tensor is made of floats.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d angular_velocity(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body_inv,
                                 const Eigen::Vector3d& L) {
  // ω = R I_body⁻¹ Rᵀ L: into the body's axes, where the tensor is constant, and back.
  const Eigen::Vector3d L_body = R.transpose() * L;
  const Eigen::Vector3d omega_body = I_body_inv.cast<float>().cast<double>() * L_body;
  return R * omega_body;
}

}  // namespace momentum
