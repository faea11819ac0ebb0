// Attack: probes where solutions are, and takes what it finds.
// Verdict: wrong | forbidden include
#if __has_include("@ROOT@/solutions/04_quaternions/product.cpp")
#include "@ROOT@/solutions/04_quaternions/product.cpp"
#else
namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
#endif
