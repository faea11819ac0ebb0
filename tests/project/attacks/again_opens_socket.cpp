// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it talks to
//         the network.
// Verdict: crashed
#include <sys/socket.h>

#include <cstdio>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  if (socket(AF_INET, SOCK_STREAM, 0) >= 0) std::fputs("root:x:0:0 the network is open\n", stderr);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
