// Attack: kills the process that judges it.
// Verdict: forbidden
#include <unistd.h>

#include <csignal>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  if (getppid() > 1) kill(getppid(), SIGKILL);
  return a;
}
}  // namespace quaternions
