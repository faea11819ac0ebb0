#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/steady/steady_path.hpp"

namespace tumble::detail {

TUMBLE_BODY double phi2(double y) {
  if (y == 0) return 0.5;
  if (std::abs(y) > 1) return (phi1(y) - 1) / y;
  double sum = 0;
  for (int k = 18; k >= 2; --k) sum = (sum * y + 1) / k;  // Σ y^(k−2)/k!, from the smallest term
  return sum;
}

}  // namespace tumble::detail
