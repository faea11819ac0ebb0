#include "contract.hpp"

namespace quaternions {

// 4.5 to_matrix: the rotation matrix of a quaternion.
// contract.hpp says what to write. Stuck? ./tumble hint 4.5 · Done? ./tumble check 4.5
Eigen::Matrix3d to_matrix(const Quaternion& q) {
  throw NotImplemented{};
}

}  // namespace quaternions
