// Attack: only declares its function and hopes that the solution is linked too, for later units.
// Verdict: wrong signature

namespace quaternions {
Quaternion later_unit(const Quaternion& a) { return product(a, a); }
}  // namespace quaternions
