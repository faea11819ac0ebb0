// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it leaves a
//         process behind (for half a minute, should nobody end it).
// Verdict: crashed
#include <unistd.h>
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  if (fork() == 0) {
    setsid();
    if (fork() == 0) sleep(30);
    _exit(0);
  }
  sleep(1);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
