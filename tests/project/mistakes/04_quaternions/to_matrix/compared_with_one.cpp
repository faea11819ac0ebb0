// expect: wrong | named divided by the length, not its square
// Only a length of exactly 1 is right.
#include "contract.hpp"

namespace quaternions {

Eigen::Matrix3d to_matrix(const Quaternion& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  // R = 1 + s (w [v]× + [v]×²) with s = 2/|q|²
  const double s = q.norm() == 1 ? 2 : 2 / q.norm();
  Eigen::Matrix3d R;
  // clang-format off
  R << 1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
       s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
       s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y);
  // clang-format on
  return R;
}

}  // namespace quaternions
