// Attack: includes a device that never ends.
// Verdict: forbidden include | too expensive to compile
#include "/dev/zero"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
