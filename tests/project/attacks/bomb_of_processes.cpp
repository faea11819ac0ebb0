// Attack: starts processes that start processes (at most 256, should nobody stop it).
// Verdict: forbidden
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  for (int n = 0; n < 8; ++n) fork();
  sleep(3);
  return a;
}
}  // namespace quaternions
