// Attack: learns by a pragma whether a file is newer than itself.
// Verdict: forbidden include | does not compile | wrong
#pragma GCC dependency "@ROOT@/solutions/04_quaternions/product.cpp" out of date

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
