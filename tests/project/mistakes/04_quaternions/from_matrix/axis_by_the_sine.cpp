// expect: wrong | named not a number
// The axis is divided by the sine, which is 0 for no turn and for half a turn.
#include <cmath>
#include "contract.hpp"

namespace quaternions {

Quaternion from_matrix(const Eigen::Matrix3d& R) {
  // 4w² = 1 + R₀₀ + R₁₁ + R₂₂, 4x² = 1 + R₀₀ − R₁₁ − R₂₂, …: they sum to 4, so one is at least 1
  const Eigen::Vector4d squares(1 + R(0, 0) + R(1, 1) + R(2, 2), 1 + R(0, 0) - R(1, 1) - R(2, 2),
                                1 - R(0, 0) + R(1, 1) - R(2, 2), 1 - R(0, 0) - R(1, 1) + R(2, 2));
  // 4wx = R₂₁ − R₁₂, 4xy = R₁₀ + R₀₁, …
  const double wx = R(2, 1) - R(1, 2), wy = R(0, 2) - R(2, 0), wz = R(1, 0) - R(0, 1);
  const double angle = std::acos((squares[0] - 2) / 2);
  const Eigen::Vector3d axis = Eigen::Vector3d(wx, wy, wz) / (2 * std::sin(angle));
  Quaternion q;
  q << std::cos(angle / 2), std::sin(angle / 2) * axis;
  return q;
}

}  // namespace quaternions
