#include "contract.hpp"

namespace rigid_body {

// 9.2 unpack: thirteen numbers become a state.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 9.2 · Be judged: ./tumble check 9.2
State unpack(const PackedState& y) {
  throw NotImplemented{};
}

}  // namespace rigid_body
