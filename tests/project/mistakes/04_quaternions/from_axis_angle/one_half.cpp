// expect: wrong | named whole-number division
// 1/2 is 0: nothing turns.
#include <cmath>

#include "contract.hpp"

namespace quaternions {

Quaternion from_axis_angle(const Eigen::Vector3d& axis, double angle) {
  const Eigen::Vector3d u = axis / axis.norm();
  const double half = angle * (1 / 2);
  // q = ⟨cos ½θ, sin ½θ u⟩
  const Eigen::Vector3d v = std::sin(half) * u;
  return {std::cos(half), v.x(), v.y(), v.z()};
}

}  // namespace quaternions
