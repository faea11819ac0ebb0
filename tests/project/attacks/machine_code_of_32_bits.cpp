// Attack: a system call by the gate for programs of 32 bits, whose numbers mean other calls.
// A kernel without that gate ends the program as for any wrong instruction.
// Verdict: forbidden | crashed

__attribute__((section(".text"))) const unsigned char code[] = {0xb8, 2, 0, 0, 0, 0xcd, 0x80, 0xc3};

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  reinterpret_cast<void (*)()>(const_cast<unsigned char*>(code))();
  return a;
}
}  // namespace quaternions
