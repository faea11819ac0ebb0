#include "contract.hpp"

namespace when_bodies_meet {

Eigen::Matrix3d contact_matrix(const Body& body, const State& state, const Eigen::Vector3d& point) {
  const Eigen::Matrix3d R = rigid_body::derived(body, state).R;
  const Eigen::Matrix3d inverse = R * body.I_body_inv * R.transpose();
  // A unit impulse j turns by ω = I⁻¹ (r × j), and that moves the point by ω × r.
  const Eigen::Matrix3d arm = rotation_matrices::skew(point - state.x);
  const Eigen::Matrix3d turning = arm * inverse * arm.transpose();
  // K = 1/m + [r]× I⁻¹ [r]×ᵀ, and the mean with its transpose is symmetric to the last bit.
  return Eigen::Matrix3d::Identity() / body.mass + (turning + turning.transpose()) / 2;
}

}  // namespace when_bodies_meet
