// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it never
//         ends.
// Verdict: crashed
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  volatile bool forever = true;
  while (forever) {
  }
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
