// Attack: includes the environment of the compiler, to read it in the errors.
// Verdict: forbidden include
#include "/proc/self/environ"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
