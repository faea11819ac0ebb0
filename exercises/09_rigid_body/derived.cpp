#include "contract.hpp"

namespace rigid_body {

// 9.3 derived: what follows from a state.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 9.3 · Be judged: ./tumble check 9.3
Derived derived(const Body& body, const State& state) {
  throw NotImplemented{};
}

}  // namespace rigid_body
