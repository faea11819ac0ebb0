// Attack: asks for memory until there is none (at most 8 GB, should nobody stop it).
// Verdict: out of memory | hung

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  std::vector<std::vector<double>> hoard;
  for (int n = 0; n < 1000; ++n) hoard.emplace_back(std::size_t{1} << 20, a[0]);
  return hoard.back()[0] * b;
}
}  // namespace quaternions
