// expect: wrong
// omega is taken to be in degrees.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d rotation_dot(const Eigen::Matrix3d& R, const Eigen::Vector3d& omega) {
  // Ṙ = [ω]× R: every column, an axis of the body, moves as ω × axis.
  return skew(omega * 3.14159265358979323846 / 180) * R;
}

}  // namespace rotation_matrices
