// expect: wrong | named not a number | may be named never set
// The zeros of a turn were never set.
#include <cmath>

#include "contract.hpp"

namespace rotation_matrices {

namespace {

/// The turn by `angle` about axis 0, 1 or 2, by the right hand.
Eigen::Matrix3d turn(int axis, double angle) {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix3d R;
  R(axis, axis) = 1;
  R(next, next) = R(last, last) = c;
  // The column of the next axis: it turns towards the last one, e → c e + s e'.
  R(last, next) = s;
  R(next, last) = -s;
  return R;
}

}  // namespace

Eigen::Matrix3d euler_angles_to_matrix(const Eigen::Vector3d& angles,
                                       const std::array<int, 3>& axes) {
  // R = R_i(α) R_j(β) R_k(γ)
  return turn(axes[0], angles[0]) * turn(axes[1], angles[1]) * turn(axes[2], angles[2]);
}

}  // namespace rotation_matrices
