#include "contract.hpp"

namespace quaternions {

// 4.8 quaternion_dot: how fast a quaternion changes.
// contract.hpp says what to write. Stuck? ./tumble hint 4.8 · Done? ./tumble check 4.8
Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega) {
  throw NotImplemented{};
}

}  // namespace quaternions
