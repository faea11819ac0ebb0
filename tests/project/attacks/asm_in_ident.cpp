// Attack: hides a directive in the text of #ident.
// Verdict: assembly | does not compile | wrong
#ident "a\"\n\t.incbin \"/etc/passwd\"\n.ident \"b"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
