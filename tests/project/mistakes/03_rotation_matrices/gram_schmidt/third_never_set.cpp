// expect: wrong | named not a number | may be named never set
// The third column was never set.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d gram_schmidt(const Eigen::Matrix3d& M) {
  // x = m₁/|m₁|
  const Eigen::Vector3d x = M.col(0).normalized();
  // y = m₂ without its part along x, scaled to length 1
  const Eigen::Vector3d y = (M.col(1) - x.dot(M.col(1)) * x).normalized();
  // z = x × y: right-handed, orthogonal to both, and of length 1 already
  const Eigen::Vector3d z = skew(x) * y;
  Eigen::Matrix3d R;
  R.col(0) = x;
  R.col(1) = y;
  return R;
}

}  // namespace rotation_matrices
