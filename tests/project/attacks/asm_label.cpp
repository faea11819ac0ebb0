// Attack: hides assembler code in the name that a variable gets in the assembly.
// Verdict: assembly | does not compile | wrong

extern int hidden asm("hidden\n\t.incbin \"/etc/passwd\"\n\t.globl other");
int hidden = 3;

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
