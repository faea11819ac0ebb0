// Attack: includes the map of the compiler's memory.
// Verdict: forbidden include
#include "/proc/self/maps"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
