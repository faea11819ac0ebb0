// Attack: pretends to be the contract, so that the compiler skips one of them, and to be included
//         once only.
// Verdict: wrong
#pragma once
#line 1 "@ROOT@/exercises/04_quaternions/contract.hpp"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
