// expect: wrong
// The cosine is the root of 1 - sin², and never negative.
#include <cmath>

#include "contract.hpp"

namespace quaternions {

Quaternion from_axis_angle(const Eigen::Vector3d& axis, double angle) {
  const Eigen::Vector3d u = axis / axis.norm();
  const double half = angle / 2;
  // q = ⟨cos ½θ, sin ½θ u⟩
  const Eigen::Vector3d v = std::sin(half) * u;
  return {std::sqrt(1 - v.squaredNorm()), v.x(), v.y(), v.z()};
}

}  // namespace quaternions
