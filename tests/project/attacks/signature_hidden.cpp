// Attack: defines the function in a namespace without name.
// Verdict: wrong signature | does not compile

namespace quaternions {
namespace {
Quaternion product(const Quaternion& a, const Quaternion& b) { return a + b; }
}  // namespace
}  // namespace quaternions
