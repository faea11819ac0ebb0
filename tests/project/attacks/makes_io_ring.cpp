// Attack: opens files through io_uring, which filters of system calls do not see.
// Verdict: forbidden
#include <sys/syscall.h>
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  char parameters[256] = {};
  syscall(SYS_io_uring_setup, 4, parameters);
  return a;
}
}  // namespace quaternions
