// Attack: includes by the directive for wrapped headers.
// Verdict: forbidden include | does not compile
#include_next "/etc/passwd"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
