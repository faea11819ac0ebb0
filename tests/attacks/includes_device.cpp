// Attack: includes a device that never ends.
// Verdict: forbidden include
#include "/dev/zero"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
