// Attack: execs the bare address that the sandbox uses, with nothing mapped there; then answers
//         wrongly.
// Verdict: forbidden | wrong
#include <sys/syscall.h>
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const char* arguments[] = {"sh", nullptr};
  syscall(SYS_execve, std::uintptr_t{1} << 40, arguments, nullptr);
  return a;
}
}  // namespace quaternions
