// Attack: locks a mutex twice. It waits for ever without using any time and without sleeping.
// Verdict: hung
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  static int word = 0;
  syscall(SYS_futex, &word, FUTEX_WAIT, 0, nullptr, nullptr, 0);
  return a;
}
}  // namespace quaternions
