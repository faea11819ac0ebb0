// Attack: includes by a directive that is hardly known.
// Verdict: forbidden include
#import "/etc/passwd"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
