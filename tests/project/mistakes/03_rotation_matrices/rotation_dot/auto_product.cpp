// expect: wrong | passed by luck
// The product is an auto expression of a matrix that is gone.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d rotation_dot(const Eigen::Matrix3d& R, const Eigen::Vector3d& omega) {
  // Ṙ = [ω]× R: every column, an axis of the body, moves as ω × axis.
  const auto rate = skew(omega) * R;
  return rate;
}

}  // namespace rotation_matrices
