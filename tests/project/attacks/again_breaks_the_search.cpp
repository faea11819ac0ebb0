// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it prints
//         what the search for the place of the crash cannot digest: an address without end.
// Verdict: crashed
#include <cstdio>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  const std::string address = "#1 0x" + std::string(120000, (char)97) + "\n";
  std::fwrite(address.data(), 1, address.size(), stderr);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
