#include "contract.hpp"

namespace rotation_matrices {

// 3.1 euler_angles_to_matrix: three turns make an orientation.
// contract.hpp says what to write. Stuck? ./tumble hint 3.1 · Done? ./tumble check 3.1
Eigen::Matrix3d euler_angles_to_matrix(const Eigen::Vector3d& angles,
                                       const std::array<int, 3>& axes) {
  throw NotImplemented{};
}

}  // namespace rotation_matrices
