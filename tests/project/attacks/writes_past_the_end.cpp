// Attack: writes far past the end of what it was given.
// Verdict: crashed | wrong

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  auto* far = const_cast<double*>(a.data());
  for (int n = 0; n < 100000000; ++n) far[n] = b[0];
  return a;
}
}  // namespace quaternions
