// expect: wrong
// A slow turn is taken for none.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d rotation_dot(const Eigen::Matrix3d& R, const Eigen::Vector3d& omega) {
  // Ṙ = [ω]× R: every column, an axis of the body, moves as ω × axis.
  if (omega.norm() < 1e-8) return Eigen::Matrix3d::Zero();
  return skew(omega) * R;
}

}  // namespace rotation_matrices
