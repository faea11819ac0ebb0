// Attack: the compiler itself is to compute for ever.
// Verdict: too expensive to compile | does not compile

constexpr unsigned collatz(unsigned n, unsigned m) {
  unsigned x = n;
  for (unsigned i = 0; i < 200000; ++i) x = x * 1664525 + m;
  return x;
}
template <unsigned n>
constexpr unsigned rounds = collatz(rounds<n - 1>, n) + rounds<n - 1>;
template <>
constexpr unsigned rounds<0> = 1;
constexpr unsigned bomb = rounds<800>;

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
