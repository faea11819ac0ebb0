#include "contract.hpp"

namespace rotation_matrices {

// 3.2 skew: the cross product as a matrix.
// contract.hpp says what to write. Stuck? ./tumble hint 3.2 · Done? ./tumble check 3.2
Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  throw NotImplemented{};
}

}  // namespace rotation_matrices
