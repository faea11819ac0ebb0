// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it prints
//         without end.
// Verdict: crashed
#include <cstdio>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  for (int n = 0; n < 50000000; ++n) std::fputs("runtime error: flood\n", stderr);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
