// Attack: includes itself without end.
// Verdict: does not compile | too expensive to compile
#include "product.cpp"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
