// expect: crashed
// The components are counted from 1.
#include "contract.hpp"

namespace rotation_matrices {

Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  // a × b = (a_y b_z − a_z b_y, a_z b_x − a_x b_z, a_x b_y − a_y b_x)
  Eigen::Matrix3d S;
  // clang-format off
  S <<    0, -a[3],  a[2],
       a[3],     0, -a[1],
      -a[2],  a[1],     0;
  // clang-format on
  return S;
}

}  // namespace rotation_matrices
