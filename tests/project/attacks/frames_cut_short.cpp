// Attack: announces a message of a megabyte and never sends it: the judge waits for the rest.
// Verdict: hung
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  if (write(3, "\0\0\x10\0 and so on", 14) < 0) return 2 * a;
  return a;
}
}  // namespace quaternions
