#include "contract.hpp"

namespace rotation_matrices {

// 3.5 nearest_rotation: the rotation that changes a matrix least.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 3.5 · Be judged: ./tumble check 3.5
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M) {
  throw NotImplemented{};
}

}  // namespace rotation_matrices
