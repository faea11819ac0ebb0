// expect: wrong | named diagonal only
// Only the diagonal of the inverse is used.
#include "contract.hpp"

namespace rigid_body {

Derived derived(const Body& body, const State& state) {
  const Eigen::Matrix3d R = quaternions::to_matrix(state.q);
  // v = P/m
  const Eigen::Vector3d v = state.P / body.mass;
  // ω = R I_body⁻¹ Rᵀ L
  const Eigen::Vector3d omega = R * body.I_body_inv.diagonal().asDiagonal() * R.transpose() * state.L;
  return {R, v, omega};
}

}  // namespace rigid_body
