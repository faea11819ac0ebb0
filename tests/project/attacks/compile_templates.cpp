// Attack: templates that need each other exponentially.
// Verdict: too expensive to compile | does not compile

template <int n, int m>
struct Bomb {
  using left = typename Bomb<n - 1, 2 * m>::type;
  using right = typename Bomb<n - 1, 2 * m + 1>::type;
  struct type {
    left a;
    right b;
  };
};
template <int m>
struct Bomb<0, m> {
  struct type {
    char c[m % 7 + 1];
  };
};
Bomb<22, 0>::type bomb;

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
