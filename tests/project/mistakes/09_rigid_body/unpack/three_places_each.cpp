// expect: wrong | named three places for the quaternion
// P and L are read as if q had three numbers.
#include "contract.hpp"

namespace rigid_body {

State unpack(const PackedState& y) {
  // y = (x, q, P, L): they start at the places 0, 3, 7 and 10
  return {y.segment<3>(0), y.segment<4>(3), y.segment<3>(6), y.segment<3>(9)};
}

}  // namespace rigid_body
