// Attack: asks for a personality in which all that can be read can be executed.
// Verdict: forbidden
#include <sys/personality.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  personality(READ_IMPLIES_EXEC);
  return a;
}
}  // namespace quaternions
