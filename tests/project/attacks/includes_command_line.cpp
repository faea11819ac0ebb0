// Attack: includes the command line of the compiler.
// Verdict: forbidden include
#include "/proc/self/cmdline"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
