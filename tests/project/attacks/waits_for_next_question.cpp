// Attack: reads the judge's next question away, and waits for one that never comes.
// Verdict: hung
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  char byte;
  while (read(4, &byte, 1) == 1) {
  }
  return a;
}
}  // namespace quaternions
