// Attack: reads /etc/passwd while it runs and prints it.
// Verdict: forbidden
#include <fstream>
#include <iostream>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::cout << std::ifstream("/etc/passwd").rdbuf() << std::flush;
  return a;
}
}  // namespace quaternions
