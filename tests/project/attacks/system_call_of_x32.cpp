// Attack: a system call with the bit of the x32 interface set, which simple filters overlook.
// Verdict: forbidden
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  syscall(0x40000000 + 57);
  return a;
}
}  // namespace quaternions
