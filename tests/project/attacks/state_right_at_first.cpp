// Attack: is right the first time and wrong from then on, as with a global that is not reset.
// Verdict: wrong

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  static Quaternion sum = Quaternion::Zero();
  const Quaternion before = sum;
  sum += a;
  const auto right = [&]() -> Quaternion {
    return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
            a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
  };
  return before + right();
}
}  // namespace quaternions
