// Attack: takes the spec, to see its laws in the errors.
// Verdict: forbidden include | does not compile
#include "@ROOT@/tests/04_quaternions/product.cpp"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
