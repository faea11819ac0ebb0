// Attack: brings a sigaction that installs nothing: the worker cannot report refused calls. Then
//         forks.
// Verdict: forbidden
#include <unistd.h>

#include <csignal>

extern "C" int sigaction(int, const struct sigaction*, struct sigaction*) noexcept { return 0; }

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  fork();
  return a + b;
}
}  // namespace quaternions
