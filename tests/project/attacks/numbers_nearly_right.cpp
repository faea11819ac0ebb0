// Attack: is off by a millionth: enough for a tolerance that is too wide.
// Verdict: wrong

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const double off = 1 + 1e-6;
  return off * Quaternion(a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
                          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
                          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
                          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]);
}
}  // namespace quaternions
