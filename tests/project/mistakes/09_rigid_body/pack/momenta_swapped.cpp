// expect: wrong | named momenta swapped
// P and L have changed places.
#include "contract.hpp"

namespace rigid_body {

PackedState pack(const State& state) {
  PackedState y;
  // y = (x, q, P, L): 3 + 4 + 3 + 3 numbers
  y << state.x, state.q, state.L, state.P;
  return y;
}

}  // namespace rigid_body
