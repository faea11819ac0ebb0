// expect: wrong | named momenta swapped
// P and L have changed places.
#include "contract.hpp"

namespace rigid_body {

State unpack(const PackedState& y) {
  // y = (x, q, P, L): they start at the places 0, 3, 7 and 10
  return {y.segment<3>(0), y.segment<4>(3), y.segment<3>(10), y.segment<3>(7)};
}

}  // namespace rigid_body
