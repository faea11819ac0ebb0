// expect: wrong
// noalias() is said of a matrix that stands on both sides.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body) {
  // I = R I_body Rᵀ: read from the right, into body axes, there to a momentum, and back.
  Eigen::Matrix3d I = I_body;
  I.noalias() = R * I;
  I.noalias() = I * R.transpose();
  return I;
}

}  // namespace point_sampling
