// Attack: brings an _exit that returns: refused calls do not end the process. Then reads
//         /etc/passwd.
// Verdict: forbidden
#include <fstream>
#include <iostream>

extern "C" void _exit(int) { throw 1; }

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  std::cout << std::ifstream("/etc/passwd").rdbuf() << std::flush;
  return a + b;
}
}  // namespace quaternions
