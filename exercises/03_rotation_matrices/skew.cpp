#include "contract.hpp"

namespace rotation_matrices {

// 3.2 skew: the cross product as a matrix.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 3.2 · Be judged: ./tumble check 3.2
Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  throw NotImplemented{};
}

}  // namespace rotation_matrices
