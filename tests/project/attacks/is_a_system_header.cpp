// Attack: calls itself a system header: no warnings, more rights.
// Verdict: wrong
#pragma GCC system_header
#line 1 "/usr/include/c++/12/vector"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
