// Attack: includes a program, to see in the errors what is in it.
// Verdict: forbidden include | does not compile
#include "/bin/sh"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
