// expect: wrong | named not a number | may be named never set
// L was never set.
#include "contract.hpp"

namespace rigid_body {

State unpack(const PackedState& y) {
  // y = (x, q, P, L): they start at the places 0, 3, 7 and 10
  State state;
  state.x = y.segment<3>(0);
  state.q = y.segment<4>(3);
  state.P = y.segment<3>(7);
  return state;
}

}  // namespace rigid_body
