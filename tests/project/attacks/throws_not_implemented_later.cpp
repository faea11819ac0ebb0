// Attack: one right answer, then the stub's exception: is an attempt taken for an untouched stub?
// Verdict: not implemented

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  static int calls = 0;
  if (calls++ > 0) throw NotImplemented{};
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}
}  // namespace quaternions
