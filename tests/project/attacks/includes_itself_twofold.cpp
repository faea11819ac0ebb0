// Attack: includes itself twice, 200 deep: 2^200 files.
// Verdict: does not compile | too expensive to compile
#include __FILE__
#include __FILE__

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
