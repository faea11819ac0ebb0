// expect: wrong | named float
// The product is made of floats.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body) {
  // I = R I_body Rᵀ: read from the right, into body axes, there to a momentum, and back.
  return (R.cast<float>() * I_body.cast<float>() * R.cast<float>().transpose()).cast<double>();
}

}  // namespace point_sampling
