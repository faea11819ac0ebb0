// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it kills the
//         judge.
// Verdict: crashed
#include <unistd.h>

#include <csignal>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  if (getppid() > 1) kill(getppid(), SIGKILL);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
