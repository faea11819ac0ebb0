// Attack: renames its function: the judge asks for one that is not there.
// Verdict: wrong signature
#define product quotient

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
