// Attack: the header's name is put together by macros.
// Verdict: forbidden include
#define FOLDER Eigen
#define NAME(x) <FOLDER/x>
#include NAME(Geometry)

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Eigen::Quaterniond p(a[0], a[1], a[2], a[3]), q(b[0], b[1], b[2], b[3]), r = p * q;
  return {r.w(), r.x(), r.y(), r.z()};
}
}  // namespace quaternions
