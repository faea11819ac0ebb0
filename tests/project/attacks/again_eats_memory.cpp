// Attack: crashes, so that it is run again with sanitizers, behind lower walls; there it takes all
//         memory that it gets (at most 3 GB, should nobody stop it).
// Verdict: crashed
@sanitized@

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
#ifdef __SANITIZE_ADDRESS__
  std::vector<std::vector<double>> hoard;
  for (int n = 0; n < 384; ++n) hoard.emplace_back(std::size_t{1} << 20, a[0]);
#endif
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
