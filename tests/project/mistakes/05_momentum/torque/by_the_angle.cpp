// expect: wrong | named not a number
// The torque is made from its length and direction, which has none for parallel ones.
#include <cmath>
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  const Eigen::Vector3d arm = p - x;
  // τ = (p − x) × F
  const Eigen::Vector3d n = rotation_matrices::skew(arm) * force;
  const double angle = std::acos(arm.dot(force) / (arm.norm() * force.norm()));
  return arm.norm() * force.norm() * std::sin(angle) * n / n.norm();
}

}  // namespace momentum
