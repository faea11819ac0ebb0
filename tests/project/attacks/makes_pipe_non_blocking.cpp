// Attack: switches its pipes to another mode, which the judge's ends would share.
// Verdict: forbidden
#include <fcntl.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  fcntl(0, F_SETFL, O_NONBLOCK);
  fcntl(3, F_SETFL, O_NONBLOCK);
  return a;
}
}  // namespace quaternions
