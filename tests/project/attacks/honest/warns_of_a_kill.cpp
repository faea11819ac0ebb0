// Attack: none. The compiler warns in words that it has for a program that was killed.
// Verdict: passed
// Laws: 5
#warning "c++: fatal error: Killed signal terminated program cc1plus"
#pragma message("signal 9 [Killed]")

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}
}  // namespace quaternions
