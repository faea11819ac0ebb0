// Attack: makes its own data executable.
// Verdict: forbidden
#include <sys/mman.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  alignas(4096) static char page[4096];
  mprotect(page, sizeof page, PROT_READ | PROT_WRITE | PROT_EXEC);
  return a;
}
}  // namespace quaternions
