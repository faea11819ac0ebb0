#include "contract.hpp"

namespace point_sampling {

// 6.5 rotate_inertia: the tensor of a body that is turned.
// contract.hpp says what to write. Stuck? ./tumble hint 6.5 · Done? ./tumble check 6.5
Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body) {
  throw NotImplemented{};
}

}  // namespace point_sampling
