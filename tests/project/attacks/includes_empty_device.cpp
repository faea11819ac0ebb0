// Attack: includes a device that is empty, which may be open to compilers.
// Verdict: forbidden include
#include "/dev/null"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
