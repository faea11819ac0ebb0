// expect: wrong | passed by luck
// z is an auto expression of a matrix that is gone.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d gram_schmidt(const Eigen::Matrix3d& M) {
  // x = m₁/|m₁|
  const Eigen::Vector3d x = M.col(0).normalized();
  // y = m₂ without its part along x, scaled to length 1
  const Eigen::Vector3d y = (M.col(1) - x.dot(M.col(1)) * x).normalized();
  // z = x × y: right-handed, orthogonal to both, and of length 1 already
  const auto z = skew(x) * y;
  Eigen::Matrix3d R;
  R << x, y, z;
  return R;
}

}  // namespace rotation_matrices
