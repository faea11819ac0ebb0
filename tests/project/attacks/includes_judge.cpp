// Attack: takes the headers of the judge, to know its protocol.
// Verdict: forbidden include | does not compile
#include "judge/worker/serve.hpp"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
