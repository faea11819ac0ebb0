// Attack: divides integers by zero.
// Verdict: crashed

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  volatile int zero = 0;
  return (a + b) * (7 / zero);
}
}  // namespace quaternions
