// Attack: hides an instruction, not a directive, in the name of a section.
// Verdict: assembly | forbidden | does not compile | wrong signature

__attribute__((section(
    ".text\n\t.globl hidden\nhidden:\n\tmovl $57, %eax\n\tsyscall\n\tret\n#"))) int value = 3;
extern "C" long hidden();

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  return a * static_cast<double>(hidden() + value);
}
}  // namespace quaternions
