// Attack: sleeps for an hour: no processor time is used, so a limit of that never comes.
// Verdict: forbidden
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  sleep(3600);
  return a;
}
}  // namespace quaternions
