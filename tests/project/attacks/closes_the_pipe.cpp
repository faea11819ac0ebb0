// Attack: closes the pipe for answers, so that the judge waits.
// Verdict: forbidden
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  close(3);
  return a;
}
}  // namespace quaternions
