// expect: wrong
// A short axis is taken for none.
#include <cmath>

#include "contract.hpp"

namespace quaternions {

Quaternion from_axis_angle(const Eigen::Vector3d& axis, double angle) {
  if (axis.norm() < 1e-9) return {1, 0, 0, 0};
  const Eigen::Vector3d u = axis / axis.norm();
  const double half = angle / 2;
  // q = ⟨cos ½θ, sin ½θ u⟩
  const Eigen::Vector3d v = std::sin(half) * u;
  return {std::cos(half), v.x(), v.y(), v.z()};
}

}  // namespace quaternions
