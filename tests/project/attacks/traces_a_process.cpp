// Attack: attaches to another process as a debugger does, to change its variables.
// Verdict: forbidden
#include <sys/ptrace.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  ptrace(PTRACE_ATTACH, 0x3fffffff, nullptr, nullptr);
  return a;
}
}  // namespace quaternions
