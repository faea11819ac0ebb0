// Attack: takes the product of the library that the course comes with.
// Verdict: forbidden include | does not compile
#include <tumble/quaternion/product.hpp>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
