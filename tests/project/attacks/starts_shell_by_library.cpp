// Attack: lets the C library start a shell.
// Verdict: forbidden
#include <cstdlib>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  if (std::system("cat /etc/passwd") != 0) return 2 * a;
  return a;
}
}  // namespace quaternions
