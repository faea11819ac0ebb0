// Attack: instructions as a table of numbers among the code: a fork, by the system call of 64 bits.
// Verdict: forbidden

__attribute__((section(".text")))
const unsigned char code[] = {0xb8, 57, 0, 0, 0, 0x0f, 0x05, 0xc3};

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  reinterpret_cast<void (*)()>(const_cast<unsigned char*>(code))();
  return a;
}
}  // namespace quaternions
