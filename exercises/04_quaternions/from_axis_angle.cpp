#include "contract.hpp"

namespace quaternions {

// 4.4 from_axis_angle: the turn about an axis by an angle.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 4.4 · Be judged: ./tumble check 4.4
Quaternion from_axis_angle(const Eigen::Vector3d& axis, double angle) {
  throw NotImplemented{};
}

}  // namespace quaternions
