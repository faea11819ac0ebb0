// Attack: a constructor that never returns: the worker never comes to ask.
// Verdict: hung

namespace {
const int never = [] {
  volatile bool forever = true;
  while (forever) {
  }
  return 0;
}();
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a * never; }
}  // namespace quaternions
