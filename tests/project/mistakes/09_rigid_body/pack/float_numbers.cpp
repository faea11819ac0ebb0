// expect: wrong | named float
// The position goes through floats.
#include "contract.hpp"

namespace rigid_body {

PackedState pack(const State& state) {
  PackedState y;
  // y = (x, q, P, L): 3 + 4 + 3 + 3 numbers
  y << state.x.cast<float>().cast<double>(), state.q, state.P, state.L;
  return y;
}

}  // namespace rigid_body
