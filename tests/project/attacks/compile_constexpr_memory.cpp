// Attack: the compiler itself is to fill memory.
// Verdict: too expensive to compile | does not compile
#include <array>

constexpr auto fill() {
  std::array<std::array<int, 1 << 12>, 1 << 12> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i].fill(int(i));
  return table;
}
constexpr auto one = fill();
constexpr auto two = one;
constexpr std::array<std::array<std::array<int, 1 << 12>, 1 << 12>, 3> bomb{one, two, one};

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
