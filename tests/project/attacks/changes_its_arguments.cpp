// Attack: writes into its constant arguments, in case the test computes with them afterwards.
// Verdict: wrong

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const_cast<Quaternion&>(a).setZero();
  const_cast<Quaternion&>(b).setZero();
  return a;
}
}  // namespace quaternions
