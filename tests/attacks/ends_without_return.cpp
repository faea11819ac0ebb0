// Attack: has no return statement.
// Verdict: crashed | wrong | hung | exited | malformed

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Quaternion sum = a + b;
  static_cast<void>(sum);
}
}  // namespace quaternions
