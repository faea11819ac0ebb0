// Attack: templates in templates without end.
// Verdict: does not compile | too expensive to compile

template <int n>
struct Deep {
  static constexpr int value = Deep<n + 1>::value + 1;
};
int bomb = Deep<0>::value;

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
