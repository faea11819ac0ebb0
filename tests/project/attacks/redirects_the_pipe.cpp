// Attack: makes what it prints its answer: descriptor 3 becomes the standard output.
// Verdict: forbidden
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  dup2(1, 3);
  return a;
}
}  // namespace quaternions
