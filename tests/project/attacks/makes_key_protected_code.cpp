// Attack: makes memory executable by the less known call for it.
// Verdict: forbidden
#include <sys/mman.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  alignas(4096) static char page[4096];
  pkey_mprotect(page, sizeof page, PROT_READ | PROT_WRITE | PROT_EXEC, -1);
  return a;
}
}  // namespace quaternions
