// expect: wrong | may be named float
// The squares are floats.
#include "contract.hpp"

namespace quaternions {

Quaternion from_matrix(const Eigen::Matrix3d& R) {
  // 4w² = 1 + R₀₀ + R₁₁ + R₂₂, 4x² = 1 + R₀₀ − R₁₁ − R₂₂, …: they sum to 4, so one is at least 1
  const Eigen::Vector4d squares(static_cast<float>(1 + R(0, 0) + R(1, 1) + R(2, 2)), 1 + R(0, 0) - R(1, 1) - R(2, 2),
                                1 - R(0, 0) + R(1, 1) - R(2, 2), 1 - R(0, 0) - R(1, 1) + R(2, 2));
  // 4wx = R₂₁ − R₁₂, 4xy = R₁₀ + R₀₁, …
  const double wx = R(2, 1) - R(1, 2), wy = R(0, 2) - R(2, 0), wz = R(1, 0) - R(0, 1);
  const double xy = R(1, 0) + R(0, 1), xz = R(0, 2) + R(2, 0), yz = R(2, 1) + R(1, 2);

  // Each is 4 q times one of q's numbers; the largest of them divides best.
  const Quaternion multiples[] = {{squares[0], wx, wy, wz},
                                  {wx, squares[1], xy, xz},
                                  {wy, xy, squares[2], yz},
                                  {wz, xz, yz, squares[3]}};
  int largest = 0;
  squares.maxCoeff(&largest);
  return multiples[largest].normalized();
}

}  // namespace quaternions
