// Attack: calls itself the solution, in messages and in debug information.
// Verdict: wrong
#line 1 "@ROOT@/solutions/04_quaternions/product.cpp"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
