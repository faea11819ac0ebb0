// Attack: computes without end and ignores the signal that says that its time is over.
// Verdict: hung
#include <csignal>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  std::signal(SIGXCPU, SIG_IGN);
  volatile bool forever = true;
  while (forever) {
  }
  return a + b;
}
}  // namespace quaternions
