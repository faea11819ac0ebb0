// Attack: makes itself root in a user namespace of its own.
// Verdict: forbidden
#include <sched.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return 2 * a;
  return a;
}
}  // namespace quaternions
