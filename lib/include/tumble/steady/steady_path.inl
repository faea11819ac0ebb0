#pragma once

#include "tumble/steady/steady_path.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"
#include "tumble/core/largest.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::detail {

TUMBLE_BODY double phi2(double y) {
  if (y == 0) return 0.5;
  if (std::abs(y) > 1) return (phi1(y) - 1) / y;
  double sum = 0;
  for (int k = 18; k >= 2; --k) sum = (sum * y + 1) / k;  // Σ y^(k−2)/k!, from the smallest term
  return sum;
}

}  // namespace tumble::detail

namespace tumble::steady {

TUMBLE_BODY double SteadyPath::error_bound(double t) const {
  const double y = -rate_ * t, first = t * detail::phi1(y), second = t * t * detail::phi2(y);
  // e^y loses what y has lost; where it falls, that is less than what it falls by.
  const double rounding = (4 + 2 * std::max(y, 0.0)) * detail::unit_roundoff;
  const double x_terms =
      x_.norm() + (std::abs(first) * P_.norm() + std::abs(second) * force_.norm()) / mass_;
  const double P_terms = std::exp(y) * P_.norm() + std::abs(first) * force_.norm();
  // P moves along a straight line; x may be back at the end, but not half way too.
  const double x_size = std::max({x_.norm(), x(t / 2).norm(), x(t).norm()});
  const double P_size = std::max(P_.norm(), P(t).norm());
  const auto part = [](double terms, double size) { return size > 0 ? terms / size : 0; };
  return rounding * detail::largest({part(x_terms, x_size), part(P_terms, P_size)});
}

}  // namespace tumble::steady
