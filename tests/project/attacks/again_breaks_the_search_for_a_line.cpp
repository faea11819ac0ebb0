// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it prints a
//         line number without end.
// Verdict: crashed
#include <cstdio>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  const std::string place = "product.cpp:" + std::string(120000, (char)49) + "\n";
  std::fwrite(place.data(), 1, place.size(), stderr);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
