// Attack: asks not to be killed with its parent, and leaves its group of processes.
// Verdict: forbidden
#include <sys/prctl.h>
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  setsid();
  prctl(PR_SET_PDEATHSIG, 0);
  return a;
}
}  // namespace quaternions
