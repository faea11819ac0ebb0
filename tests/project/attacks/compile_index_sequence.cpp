// Attack: a list of types with a hundred million entries.
// Verdict: too expensive to compile | does not compile
#include <utility>

template <std::size_t... i>
constexpr std::size_t sum(std::index_sequence<i...>) {
  return (i + ...);
}
const std::size_t bomb = sum(std::make_index_sequence<100000000>());

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
