#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/simulate/stated_error.hpp"

namespace tumble::detail {

TUMBLE_BODY RigidBodyState<> beside(const RigidBodyState<>& start, double part, Zeros zeros) {
  // Of both signs and all sizes.
  constexpr double share[13] = {0.83, -0.67, 0.91,  -0.74, 0.97,  0.62, -0.88,
                                0.71, 0.93,  -0.79, 0.86,  -0.95, 0.69};
  PackedState<double> y = pack(start);
  PackedState<double> sizes = y.cwiseAbs();
  sizes.segment<4>(3).setConstant(start.q.norm() / 2);          // as each of four that are equal
  sizes.tail<3>().setConstant(start.L.norm() / std::sqrt(3.));  // and of three
  for (int i = 0; i < y.size(); ++i)
    if (y[i] != 0 || zeros == Zeros::move) y[i] += part * share[i] * sizes[i];
  return unpack<double>(y);
}

}  // namespace tumble::detail
