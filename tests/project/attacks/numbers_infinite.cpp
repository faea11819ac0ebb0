// Attack: answers infinity: infinity / infinity is no number, and a relative error hides it.
// Verdict: wrong

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return Quaternion::Constant(std::numeric_limits<double>::infinity()) + 0 * (a + b);
}
}  // namespace quaternions
