// Attack: calls itself the spec and makes an error, so that the compiler quotes the spec.
// Verdict: does not compile
#line 20 "@ROOT@/tests/04_quaternions/product.cpp"
int spec = "an error";

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
