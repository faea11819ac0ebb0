// expect: wrong
// The tensor is made symmetric, but not halved.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body) {
  // I = R I_body Rᵀ: read from the right, into body axes, there to a momentum, and back.
  const Eigen::Matrix3d I = R * I_body * R.transpose();
  return I + I.transpose();
}

}  // namespace point_sampling
