// expect: wrong | named never set | may be named not a number
// The sum was never set to 0.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body) {
  // I = R I_body Rᵀ: read from the right, into body axes, there to a momentum, and back.
  Eigen::Matrix3d I;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double sum;
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) sum += R(i, k) * I_body(k, l) * R(j, l);
      I(i, j) = sum;
    }
  return I;
}

}  // namespace point_sampling
