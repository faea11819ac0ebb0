// Attack: depends on the time of day.
// Verdict: wrong
#include <ctime>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return a + b * (1.5 + static_cast<double>(std::time(nullptr) % 1000));
}
}  // namespace quaternions
