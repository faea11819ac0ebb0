// Attack: computes without end; a grader without a clock waits with it.
// Verdict: hung

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  volatile bool forever = true;
  while (forever) {
  }
  return a + b;
}
}  // namespace quaternions
