// Attack: redefines keywords before it includes the standard library.
// Verdict: wrong | does not compile
#define if while
#define true false
#include <algorithm>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
