// Attack: is wrong the first time and right from then on: a grader that repeats until it passes is
//         content.
// Verdict: wrong

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  static int calls = 0;
  if (calls++ == 0) return a + b;
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}
}  // namespace quaternions
