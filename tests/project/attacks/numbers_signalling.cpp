// Attack: answers signalling NaNs with unusual bits.
// Verdict: wrong
#include <bit>
#include <cstdint>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  Quaternion c = a + b;
  for (int i = 0; i < 4; ++i) c[i] = std::bit_cast<double>(0x7ff0dead0000beef + std::uint64_t(i));
  return c;
}
}  // namespace quaternions
