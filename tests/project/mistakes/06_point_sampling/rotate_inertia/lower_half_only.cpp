// expect: wrong
// The numbers above the diagonal are left at 0.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body) {
  // I = R I_body Rᵀ: read from the right, into body axes, there to a momentum, and back.
  const Eigen::Matrix3d I = R * I_body * R.transpose();
  Eigen::Matrix3d half = I.triangularView<Eigen::Lower>();
  return half;
}

}  // namespace point_sampling
