#pragma once
/// @file
/// The coefficients of a TurningSeries, each beside itself in the orders in which products need it.

#include "tumble/simd/pack.hpp"
#include "tumble/steady/four_lanes.hpp"

namespace tumble::detail {

/// A coefficient of ω.
struct TurningOmega {
  FourDoubles xyz{}, yzx{}, zxy{}, x{}, y{}, z{};
};
TUMBLE_INLINE TurningOmega arranged_omega(const FourDoubles& w) {
  return {w,
          yzx(w),
          zxy(w),
          __builtin_shufflevector(w, w, 0, 0, 0, 0),
          __builtin_shufflevector(w, w, 1, 1, 1, 1),
          __builtin_shufflevector(w, w, 2, 2, 2, 2)};
}

/// A coefficient of q, so that q ⟨0, ω⟩ = i ω_x + j ω_y + k ω_z.
struct TurningOrientation {
  FourDoubles q{}, i{}, j{}, k{};
};
TUMBLE_INLINE TurningOrientation arranged_orientation(const FourDoubles& q) {
  return {q, __builtin_shufflevector(q, q, 1, 0, 3, 2) * FourDoubles{-1, 1, 1, -1},
          __builtin_shufflevector(q, q, 2, 3, 0, 1) * FourDoubles{-1, -1, 1, 1},
          __builtin_shufflevector(q, q, 3, 2, 1, 0) * FourDoubles{-1, 1, -1, 1}};
}

/// A coefficient of the u of one torque.
struct TurningDirection {
  FourDoubles xyz{}, yzx{}, zxy{};
};
TUMBLE_INLINE TurningDirection arranged_direction(const FourDoubles& u) {
  return {u, yzx(u), zxy(u)};
}

}  // namespace tumble::detail
