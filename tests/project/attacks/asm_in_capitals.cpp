// Attack: as asm_in_section_name, in capitals: the assembler does not mind.
// Verdict: assembly | does not compile
#include <cstdio>

__attribute__((section(
    ".data\n\t.globl stolen\nstolen:\n\t.INCBIN \"/usr/include/stdio.h\"\n\t.byte 0\n#"))) int
    value = 3;

extern "C" const char stolen[];

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::puts(stolen);
  return a * value;
}
}  // namespace quaternions
