// Attack: includes a folder.
// Verdict: forbidden include | does not compile
#include "/etc"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
