// expect: wrong | named normalised
// q is normalised on the way.
#include "contract.hpp"

namespace rigid_body {

PackedState pack(const State& state) {
  PackedState y;
  // y = (x, q, P, L): 3 + 4 + 3 + 3 numbers
  y << state.x, state.q.normalized(), state.P, state.L;
  return y;
}

}  // namespace rigid_body
