#pragma once
/// @file
/// The terms of a turning's series, to be kept when the series goes on to the next moment.

#include "tumble/steady/four_lanes.hpp"
#include "tumble/steady/steady_torque.hpp"

namespace tumble::detail {

/// One coefficient of q and of ω.
struct TurningTerm {
  FourDoubles q, w;
};

/// The state a time h after the moment of a series, from its terms 0 … order, an even number: even
/// and odd ones side by side, which is twice as fast as one after the other.
inline steady::TurningState turning_at(const TurningTerm* terms, int order, double h) {
  const double h2 = h * h;
  TurningTerm even = terms[order], odd = terms[order - 1];
  for (int k = order - 2; k > 0; k -= 2) {
    even = {even.q * h2 + terms[k].q, even.w * h2 + terms[k].w};
    odd = {odd.q * h2 + terms[k - 1].q, odd.w * h2 + terms[k - 1].w};
  }
  const FourDoubles q = (odd.q + even.q * h) * h + terms[0].q;
  const FourDoubles w = (odd.w + even.w * h) * h + terms[0].w;
  return {Quat(q[0], q[1], q[2], q[3]), Vec3(w[0], w[1], w[2])};
}

}  // namespace tumble::detail
