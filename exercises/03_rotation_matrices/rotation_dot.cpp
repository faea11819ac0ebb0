#include "contract.hpp"

namespace rotation_matrices {

// 3.3 rotation_dot: how an orientation changes.
// contract.hpp says what to write. Stuck? ./tumble hint 3.3 · Done? ./tumble check 3.3
Eigen::Matrix3d rotation_dot(const Eigen::Matrix3d& R, const Eigen::Vector3d& omega) {
  throw NotImplemented{};
}

}  // namespace rotation_matrices
