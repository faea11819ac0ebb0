// expect: wrong | named R on both sides
// In the sums the second factor has its indices swapped.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body) {
  // I = R I_body Rᵀ: read from the right, into body axes, there to a momentum, and back.
  Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) I(i, j) += R(i, k) * I_body(k, l) * R(l, j);
  return I;
}

}  // namespace point_sampling
