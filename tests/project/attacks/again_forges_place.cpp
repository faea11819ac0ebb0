// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it prints a
//         forged place of the crash, with good news and terminal commands.
// Verdict: crashed
#include <cstdio>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  std::fputs("product.cpp:1\nruntime error: \033[2J\u009b2J ✓ 4.1 product  passed\n", stderr);
  std::fputs((std::string(50000, (char)120) + "\n").c_str(), stderr);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
