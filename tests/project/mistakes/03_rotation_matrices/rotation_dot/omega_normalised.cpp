// expect: wrong
// Only the direction of omega is used.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d rotation_dot(const Eigen::Matrix3d& R, const Eigen::Vector3d& omega) {
  // Ṙ = [ω]× R: every column, an axis of the body, moves as ω × axis.
  return skew(omega.normalized()) * R;
}

}  // namespace rotation_matrices
