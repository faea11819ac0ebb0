// Attack: none. Multiplies matrices of any size, for which Eigen asks the processor for its caches
// and
//         comments its own assembly.
// Verdict: passed
// Laws: 5
#include "contract.hpp"

namespace quaternions {

Quaternion product(const Quaternion& a, const Quaternion& b) {
  Eigen::MatrixXd left(4, 4), right(4, 1);
  left << a[0], -a[1], -a[2], -a[3],  //
      a[1], a[0], -a[3], a[2],        //
      a[2], a[3], a[0], -a[1],        //
      a[3], -a[2], a[1], a[0];
  right << b[0], b[1], b[2], b[3];
  const Eigen::MatrixXd result = left * right;
  const Eigen::MatrixXd square = left.transpose() * left;
  return square.rows() == 4 ? Quaternion(result.col(0)) : b;
}

}  // namespace quaternions
