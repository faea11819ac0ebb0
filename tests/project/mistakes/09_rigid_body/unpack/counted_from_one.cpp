// expect: crashed
// The places are counted from 1.
#include "contract.hpp"

namespace rigid_body {

State unpack(const PackedState& y) {
  // y = (x, q, P, L): they start at the places 0, 3, 7 and 10
  return {y.segment<3>(1), y.segment<4>(4), y.segment<3>(8), y.segment<3>(11)};
}

}  // namespace rigid_body
