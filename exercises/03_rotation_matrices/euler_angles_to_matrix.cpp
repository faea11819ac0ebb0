#include "contract.hpp"

namespace rotation_matrices {

// 3.1 euler_angles_to_matrix: three turns make an orientation.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 3.1 · Be judged: ./tumble check 3.1
Eigen::Matrix3d euler_angles_to_matrix(const Eigen::Vector3d& angles,
                                       const std::array<int, 3>& axes) {
  throw NotImplemented{};
}

}  // namespace rotation_matrices
