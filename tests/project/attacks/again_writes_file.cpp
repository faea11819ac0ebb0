// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it leaves a
//         file.
// Verdict: crashed
#include <fstream>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  std::ofstream("@OPEN@/here") << "passed";
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
