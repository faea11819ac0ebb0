// Attack: takes the right product from the judge's own reference.
// Verdict: forbidden include | does not compile
#include "@ROOT@/tests/judge/spec/shared/quaternion_reference.hpp"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) { return reference::product(a, b); }
}  // namespace quaternions
