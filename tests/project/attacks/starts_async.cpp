// Attack: computes in another thread, as a library may do unasked.
// Verdict: forbidden
#include <future>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  return std::async(std::launch::async, [a] { return Quaternion(2 * a); }).get();
}
}  // namespace quaternions
