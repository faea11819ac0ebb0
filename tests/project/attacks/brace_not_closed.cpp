// Attack: ends in the middle.
// Verdict: does not compile

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return a
