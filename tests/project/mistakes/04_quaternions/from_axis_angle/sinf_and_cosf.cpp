// expect: wrong | named float
// Sine and cosine are floats.
#include <cmath>

#include "contract.hpp"

namespace quaternions {

Quaternion from_axis_angle(const Eigen::Vector3d& axis, double angle) {
  const Eigen::Vector3d u = axis / axis.norm();
  const double half = angle / 2;
  // q = ⟨cos ½θ, sin ½θ u⟩
  const Eigen::Vector3d v = sinf(half) * u;
  return {cosf(half), v.x(), v.y(), v.z()};
}

}  // namespace quaternions
