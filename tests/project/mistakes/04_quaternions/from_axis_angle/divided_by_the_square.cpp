// expect: wrong
// The axis is divided by the square of its length.
#include <cmath>

#include "contract.hpp"

namespace quaternions {

Quaternion from_axis_angle(const Eigen::Vector3d& axis, double angle) {
  const Eigen::Vector3d u = axis / axis.squaredNorm();
  const double half = angle / 2;
  // q = ⟨cos ½θ, sin ½θ u⟩
  const Eigen::Vector3d v = std::sin(half) * u;
  return {std::cos(half), v.x(), v.y(), v.z()};
}

}  // namespace quaternions
