// Attack: includes nothing when its headers are looked at, and Eigen's quaternions when it is
//         compiled: by then the first pass has left files beside it.
// Verdict: forbidden include | does not compile | wrong
#if __has_include("included") || __has_include("preprocessed") || __has_include("product.s")
#include <Eigen/Geometry>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Eigen::Quaterniond p(a[0], a[1], a[2], a[3]), q(b[0], b[1], b[2], b[3]), r = p * q;
  return {r.w(), r.x(), r.y(), r.z()};
}
}  // namespace quaternions
#else
namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
#endif
