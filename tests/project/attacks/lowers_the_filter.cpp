// Attack: asks the kernel to change its own filter of system calls.
// Verdict: forbidden
#include <linux/seccomp.h>
#include <sys/prctl.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT);
  return a;
}
}  // namespace quaternions
