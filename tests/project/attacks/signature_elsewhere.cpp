// Attack: defines the function outside the namespace.
// Verdict: wrong signature

using quaternions::Quaternion;
Quaternion product(const Quaternion& a, const Quaternion& b) { return a + b; }
