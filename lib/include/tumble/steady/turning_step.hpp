#pragma once
/// @file
/// How long a step a turning's series is good for.

#include <algorithm>
#include <cmath>
#include <limits>

#include "tumble/core/largest.hpp"
#include "tumble/steady/turning_lanes.hpp"

namespace tumble::detail {

/// The longest step, in the series' unit of time, whose last terms stay below the tolerance,
/// relative to ω and to 1 for q; NaN if the terms are.
/// @param q, w the coefficients 0 … order
inline double turning_step(const TurningOrientation* q, const TurningOmega* w, int order,
                           double tolerance) {
  // A term that has underflowed may have been as large as this: nobody may take it for 0.
  constexpr double tiny = 1e-300;
  const double first = norm(w[0].xyz);
  const double q0 = norm(q[0].q), w0 = first == 0 ? norm(w[1].xyz) : first;
  if (w0 == 0) return std::numeric_limits<double>::infinity();  // at rest, and it stays so
  double per_step = 0;
  for (const int k : {order - 1, order}) {
    const double last = largest({norm(q[k].q) / q0, norm(w[k].xyz) / w0, tiny / q0, tiny / w0});
    // Three digits are plenty; single precision is faster.
    const double pace =
        std::exp2(static_cast<float>(std::log2(last / tolerance)) / static_cast<float>(k));
    per_step = largest({per_step, pace});
  }
  return 1 / per_step;
}

}  // namespace tumble::detail
