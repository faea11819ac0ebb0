// Attack: assembler code in a template, which is compiled only when it is used.
// Verdict: assembly

template <int number>
long call() {
  long result = number;
  asm volatile("syscall" : "+a"(result) : : "rcx", "r11");
  return result;
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  return a * static_cast<double>(call<57>());
}
}  // namespace quaternions
