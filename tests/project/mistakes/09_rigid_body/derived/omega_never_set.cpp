// expect: wrong | named not a number | may be named never set
// omega was never set.
#include "contract.hpp"

namespace rigid_body {

Derived derived(const Body& body, const State& state) {
  const Eigen::Matrix3d R = quaternions::to_matrix(state.q);
  // v = P/m
  const Eigen::Vector3d v = state.P / body.mass;
  // ω = R I_body⁻¹ Rᵀ L
  Derived d;
  d.R = R;
  d.v = v;
  return d;
}

}  // namespace rigid_body
