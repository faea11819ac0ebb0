#include "contract.hpp"

namespace point_sampling {

// 6.5 rotate_inertia: the tensor of a body that is turned.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 6.5 · Be judged: ./tumble check 6.5
Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body) {
  throw NotImplemented{};
}

}  // namespace point_sampling
