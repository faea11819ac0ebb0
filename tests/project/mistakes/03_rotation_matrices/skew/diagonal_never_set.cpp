// expect: wrong | named not a number | may be named never set
// The diagonal was never set.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  // a × b = (a_y b_z − a_z b_y, a_z b_x − a_x b_z, a_x b_y − a_y b_x)
  Eigen::Matrix3d S;
  // clang-format off
  S(0, 1) = -a[2]; S(0, 2) = a[1];
  S(1, 0) = a[2]; S(1, 2) = -a[0];
  S(2, 0) = -a[1]; S(2, 1) = a[0];
  // clang-format on
  return S;
}

}  // namespace rotation_matrices
