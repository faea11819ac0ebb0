#include "contract.hpp"

namespace quaternions {

// 4.4 from_axis_angle: the turn about an axis by an angle.
// contract.hpp says what to write. Stuck? ./tumble hint 4.4 · Done? ./tumble check 4.4
Quaternion from_axis_angle(const Eigen::Vector3d& axis, double angle) {
  throw NotImplemented{};
}

}  // namespace quaternions
