// Attack: writes bytes that are no message into the pipe for answers.
// Verdict: malformed
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const std::string noise(100000, '\xc1');
  if (write(3, noise.data(), noise.size()) < 0) return 2 * a;
  return a;
}
}  // namespace quaternions
