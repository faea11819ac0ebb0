// Attack: takes its arguments by value: another function for the linker.
// Verdict: wrong signature

namespace quaternions {
Quaternion product(Quaternion a, Quaternion b) { return a + b; }
}  // namespace quaternions
