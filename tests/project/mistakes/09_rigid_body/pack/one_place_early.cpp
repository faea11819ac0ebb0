// expect: wrong | named not a number | may be named never set
// P starts at place 6, on top of the last number of q.
#include "contract.hpp"

namespace rigid_body {

PackedState pack(const State& state) {
  PackedState y;
  // y = (x, q, P, L): 3 + 4 + 3 + 3 numbers
  y.segment<3>(0) = state.x;
  y.segment<4>(3) = state.q;
  y.segment<3>(6) = state.P;
  y.segment<3>(9) = state.L;
  return y;
}

}  // namespace rigid_body
