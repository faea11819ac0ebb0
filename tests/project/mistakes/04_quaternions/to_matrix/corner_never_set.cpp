// expect: wrong | named not a number | may be named never set
// The last number was never set.
#include "contract.hpp"

namespace quaternions {

Eigen::Matrix3d to_matrix(const Quaternion& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  // R = 1 + s (w [v]× + [v]×²) with s = 2/|q|²
  const double s = 2 / q.squaredNorm();
  Eigen::Matrix3d R;
  // clang-format off
  R.topRows<2>() << 1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
       s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x);
  R(2, 0) = s * (x * z - w * y);
  R(2, 1) = s * (y * z + w * x);
  // clang-format on
  return R;
}

}  // namespace quaternions
