// Attack: an empty piece of assembler, as benchmarks use it against the optimiser.
// Verdict: assembly | wrong

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  asm volatile("" : : "g"(&a) : "memory");
  return a;
}
}  // namespace quaternions
