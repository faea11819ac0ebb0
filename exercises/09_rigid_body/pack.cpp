#include "contract.hpp"

namespace rigid_body {

// 9.1 pack: a state becomes thirteen numbers.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 9.1 · Be judged: ./tumble check 9.1
PackedState pack(const State& state) {
  throw NotImplemented{};
}

}  // namespace rigid_body
