// Attack: computes without end and without effect; the language lets a compiler take such a loop for one that ends.
// Verdict: hung

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  Quaternion c = a;
  for (;;) c += b;
  return c;
}
}  // namespace quaternions
