// Attack: sends a signal to every process of its user (signal 0, which does nothing: the call is
//         what counts).
// Verdict: forbidden
#include <sys/syscall.h>
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  syscall(SYS_kill, -1, 0);
  return a;
}
}  // namespace quaternions
