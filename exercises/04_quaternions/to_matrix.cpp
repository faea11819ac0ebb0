#include "contract.hpp"

namespace quaternions {

// 4.5 to_matrix: the rotation matrix of a quaternion.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 4.5 · Be judged: ./tumble check 4.5
Eigen::Matrix3d to_matrix(const Quaternion& q) {
  throw NotImplemented{};
}

}  // namespace quaternions
