// Attack: closes all of its files at once.
// Verdict: forbidden
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  close_range(0, ~0u, 0);
  return a;
}
}  // namespace quaternions
