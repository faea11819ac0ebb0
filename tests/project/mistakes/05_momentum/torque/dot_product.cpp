// expect: wrong
// The dot product is taken for each component.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  const Eigen::Vector3d arm = p - x;
  // τ = (p − x) × F
  return Eigen::Vector3d::Constant(arm.dot(force));
}

}  // namespace momentum
