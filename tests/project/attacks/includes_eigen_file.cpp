// Attack: takes the one file of Eigen that it needs.
// Verdict: forbidden include
#include <Eigen/src/Geometry/Quaternion.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
