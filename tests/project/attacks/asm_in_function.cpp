// Attack: calls the system by assembler code.
// Verdict: assembly

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  long result;
  __asm__ volatile("syscall" : "=a"(result) : "a"(57) : "rcx", "r11", "memory");
  return a * static_cast<double>(result);
}
}  // namespace quaternions
