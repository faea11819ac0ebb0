// Attack: an alarm that ends the process with success in the middle of a later case.
// Verdict: forbidden
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::signal(SIGALRM, [](int) { std::_Exit(0); });
  alarm(1);
  return a;
}
}  // namespace quaternions
