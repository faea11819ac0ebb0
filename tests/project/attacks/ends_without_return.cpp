// Attack: has no return statement.
// Verdict: does not compile

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Quaternion sum = a + b;
  static_cast<void>(sum);
}
}  // namespace quaternions
