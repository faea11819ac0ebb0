// Attack: lets the assembler read /etc/passwd into the program.
// Verdict: assembly | does not compile

asm(".data\nstolen: .incbin \"/etc/passwd\"\n.byte 0\n.text");

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
