#include "contract.hpp"

namespace quaternions {

// 4.3 rotate: a point turned by a quaternion.
// contract.hpp says what to write. Stuck? ./tumble hint 4.3 · Done? ./tumble check 4.3
Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p) {
  throw NotImplemented{};
}

}  // namespace quaternions
