// Attack: leaves a file for later submissions or for the grader to find.
// Verdict: forbidden
#include <fstream>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::ofstream("@OPEN@/here") << "passed";
  return a;
}
}  // namespace quaternions
