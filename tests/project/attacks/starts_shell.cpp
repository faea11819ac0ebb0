// Attack: becomes a shell.
// Verdict: forbidden
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  execl("/bin/sh", "sh", "-c", "cat /etc/passwd", nullptr);
  return a;
}
}  // namespace quaternions
