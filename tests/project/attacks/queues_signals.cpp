// Attack: sends a signal by a less known call (signal 0, which does nothing).
// Verdict: forbidden
#include <csignal>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  sigqueue(1, 0, sigval{});
  return a;
}
}  // namespace quaternions
