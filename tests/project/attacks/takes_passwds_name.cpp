// Attack: calls itself /etc/passwd and makes an error, so that the compiler quotes that line of
//         that file.
// Verdict: does not compile
#line 1 "/etc/passwd"
int passwd = "an error";

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
