// Attack: reads numbers from std::cin, as first programs do.
// Verdict: hung | malformed | exited | wrong
#include <iostream>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  double number = 0;
  while (std::cin >> number) {
  }
  return a;
}
}  // namespace quaternions
