// Attack: leaves a file for later submissions or for the grader to find.
// Verdict: forbidden
// Writes: /tmp/tumble_attack_was_here
#include <fstream>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::ofstream("/tmp/tumble_attack_was_here") << "passed";
  return a;
}
}  // namespace quaternions
