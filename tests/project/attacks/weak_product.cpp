// Attack: defines its function weakly, so that any other definition counts.
// Verdict: wrong

namespace quaternions {
__attribute__((weak)) Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
