// Attack: asks for root's rights.
// Verdict: forbidden
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  if (setuid(0) != 0) return 2 * a;
  return a;
}
}  // namespace quaternions
