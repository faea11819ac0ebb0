// expect: wrong | passed by luck
// The spin is an auto expression of a matrix that is gone.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d point_velocity(const Eigen::Vector3d& x, const Eigen::Matrix3d& R,
                               const Eigen::Vector3d& v, const Eigen::Vector3d& omega,
                               const Eigen::Vector3d& p_body) {
  // From the centre of mass to the point, in world axes. Where the centre is does not matter.
  const Eigen::Vector3d r = R * p_body;
  // ṗ = v + ω × r
  const auto spin = rotation_matrices::skew(omega) * r;
  return v + spin;
}

}  // namespace momentum
