// Attack: includes a file that compilers may read about the machine.
// Verdict: forbidden include
#include "/proc/cpuinfo"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
