// expect: wrong
// The formula is one for unit quaternions.
#include "contract.hpp"

namespace quaternions {

Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p) {
  const Eigen::Vector3d u = q.tail<3>();
  // p + 2 w u × p + 2 u × (u × p)
  const Eigen::Vector3d c(u[1] * p[2] - u[2] * p[1], u[2] * p[0] - u[0] * p[2], u[0] * p[1] - u[1] * p[0]);
  return p + 2 * q[0] * c + 2 * (u * u.dot(p) - p * u.dot(u));
}

}  // namespace quaternions
