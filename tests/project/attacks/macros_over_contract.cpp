// Attack: wants to change the contract by macros, and to include it again.
// Verdict: wrong signature | does not compile
#define Quaternion double
#define NotImplemented int
#undef EIGEN_CORE_H
#include "contract.hpp"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
