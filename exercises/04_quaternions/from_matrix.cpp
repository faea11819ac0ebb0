#include "contract.hpp"

namespace quaternions {

// 4.6 from_matrix: the quaternion of a rotation matrix.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 4.6 · Be judged: ./tumble check 4.6
Quaternion from_matrix(const Eigen::Matrix3d& R) {
  throw NotImplemented{};
}

}  // namespace quaternions
