// expect: wrong | named not a number | may be named never set
// The loop over the columns ends at the second.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d rotation_dot(const Eigen::Matrix3d& R, const Eigen::Vector3d& omega) {
  // Ṙ = [ω]× R: every column, an axis of the body, moves as ω × axis.
  Eigen::Matrix3d rate;
  for (int i = 0; i < 2; ++i) rate.col(i) = skew(omega) * R.col(i);
  return rate;
}

}  // namespace rotation_matrices
