// expect: wrong | named normalised
// q is normalised on the way.
#include "contract.hpp"

namespace rigid_body {

State unpack(const PackedState& y) {
  // y = (x, q, P, L): they start at the places 0, 3, 7 and 10
  return {y.segment<3>(0), y.segment<4>(3).normalized(), y.segment<3>(7), y.segment<3>(10)};
}

}  // namespace rigid_body
