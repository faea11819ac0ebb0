// Attack: includes what the compiler is just writing.
// Verdict: forbidden include | does not compile
#include "preprocessed"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
