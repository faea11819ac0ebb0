// Attack: includes what the compiler is given as its input: it waits.
// Verdict: forbidden include
#include "/dev/stdin"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
