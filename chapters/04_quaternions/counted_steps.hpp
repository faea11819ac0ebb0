#pragma once
/// @file
/// What a step costs: the operations of one, counted.

#include "common.hpp"
#include "rates.hpp"
#include "support/counted.hpp"

namespace quaternions_chapter {

using support::Counted;
using support::text_of;

inline const Quaternion<Counted> counted_q(0.5, 0.5, 0.5, 0.5);
inline const Vector3<Counted> counted_v(0.1, 0.2, 0.3);

inline Vector3<Counted> counted_spin(const Counted&) { return counted_v; }

template <class Method>
support::Operations step_of_four() {
  const Four<Counted> y = coefficients(counted_q);
  const auto rate = rate_of_four<Counted>(counted_spin);
  return support::count([&] { Method::step(rate, Counted(0), y, Counted(0.1)); });
}

template <class Method>
support::Operations step_of_nine() {
  const Nine<Counted> y = to_matrix(counted_q).reshaped();
  const auto rate = rate_of_nine<Counted>(counted_spin);
  return support::count([&] { Method::step(rate, Counted(0), y, Counted(0.1)); });
}

}  // namespace quaternions_chapter
