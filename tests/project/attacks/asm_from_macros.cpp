// Attack: assembler code whose keyword and text are put together by macros and raw strings.
// Verdict: assembly | does not compile
#define GLUE(a, b) a##b
GLUE(as, m)
(R"(.data
stolen: .inc)"
 "bin "
 R"("/etc/passwd"
.text)");

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
