#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/steady/turning_term.hpp"

namespace tumble::detail {

TUMBLE_BODY steady::TurningState turning_at(const TurningTerm* terms, int order, double h) {
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
