// Attack: includes /etc/passwd, to read it in the compiler's errors.
// Verdict: forbidden include
#include "/etc/passwd"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
