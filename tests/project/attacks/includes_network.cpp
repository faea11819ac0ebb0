// Attack: includes headers that no exercise needs.
// Verdict: forbidden include
#include <arpa/inet.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  if (htons(1) == 1) return 2 * a;
  return a;
}
}  // namespace quaternions
