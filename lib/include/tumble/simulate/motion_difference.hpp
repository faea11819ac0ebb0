#pragma once
/// @file
/// By how much two states of one motion differ.

#include "tumble/core/largest.hpp"
#include "tumble/simulate/motion_tolerance.hpp"

namespace tumble::detail {

/// Of one body: the angle between orientations [rad], and all else a part of its size; the largest.
double difference_of_body(const PackedState<double>& a, const PackedState<double>& b,
                          const Eigen::Vector4d& per_size);

/// Of all bodies, thirteen numbers each.
/// @param per_size one over the sizes of x, q, P and L, of one body after the other
template <class Numbers>
double motion_difference(const Numbers& a, const Numbers& b,
                         const SquaredSizes<Numbers>& per_size) {
  double most = 0;
  for (Eigen::Index i = 0; i < a.size() / rigid_body_state_size; ++i) {
    const auto part = [&](const Numbers& y) {
      return PackedState<double>(
          y.template segment<rigid_body_state_size>(rigid_body_state_size * i));
    };
    const Eigen::Vector4d sizes = per_size.template segment<4>(4 * i);
    most = largest({most, difference_of_body(part(a), part(b), sizes)});
  }
  return most;
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/motion_difference.inl"
#endif
