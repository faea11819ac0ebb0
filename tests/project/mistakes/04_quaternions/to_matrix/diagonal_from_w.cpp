// expect: wrong
// The diagonal is 2 w² - 1 + 2 x², also for a long q.
#include "contract.hpp"

namespace quaternions {

Eigen::Matrix3d to_matrix(const Quaternion& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  // R = 1 + s (w [v]× + [v]×²) with s = 2/|q|²
  const double s = 2 / q.squaredNorm();
  Eigen::Matrix3d R;
  // clang-format off
  R << 2 * (w * w + x * x) - 1, s * (x * y - w * z),     s * (x * z + w * y),
       s * (x * y + w * z),     2 * (w * w + y * y) - 1, s * (y * z - w * x),
       s * (x * z - w * y),     s * (y * z + w * x),     2 * (w * w + z * z) - 1;
  // clang-format on
  return R;
}

}  // namespace quaternions
