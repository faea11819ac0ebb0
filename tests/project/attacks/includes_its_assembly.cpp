// Attack: includes the assembly that an earlier pass has left.
// Verdict: forbidden include | does not compile
#include "product.s"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
