// expect: wrong | named not a number | may be named never set
// The angular momentum was never set.
#include "contract.hpp"

namespace rigid_body {

PackedState pack(const State& state) {
  PackedState y;
  // y = (x, q, P, L): 3 + 4 + 3 + 3 numbers
  y.head<10>() << state.x, state.q, state.P;
  return y;
}

}  // namespace rigid_body
