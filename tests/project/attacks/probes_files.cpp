// Attack: learns by __has_include which files there are, and says so in its errors.
// Verdict: forbidden include | does not compile | wrong
#if __has_include("/etc/shadow")
#error there is /etc/shadow
#endif
#if __has_include("@ROOT@/tests/04_quaternions/product.cpp")
#error there is a spec
#endif

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
