// Attack: depends on the number of its process and on its addresses.
// Verdict: wrong
#include <unistd.h>

#include <cstdint>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return a +
         b * (1.5 + static_cast<double>(getpid() % 7 + reinterpret_cast<std::intptr_t>(&a) % 1024));
}
}  // namespace quaternions
