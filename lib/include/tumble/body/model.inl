#pragma once

#include "tumble/body/model.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble {

TUMBLE_BODY SymmetricMoments nearest_symmetric_top(const PrincipalAxes& p) {
  const double low = p.moments[1] - p.moments[0], high = p.moments[2] - p.moments[1];
  const int odd = low < high ? 2 : 0;  // the axis of the moment that has no equal
  const double a = p.moments[1], b = p.moments[odd == 2 ? 0 : 2];
  return {p.moments[odd], (a + b) / 2, p.R.col(odd), std::abs(a - b) / std::max(a, b)};
}

TUMBLE_BODY ModelChoice model_of_moments(const PrincipalAxes& axes, double tolerance) {
  require(tolerance >= 0 && std::isfinite(tolerance), "model_of_moments: the tolerance is ",
          tolerance, ", not a finite number ≥ 0");
  const SymmetricMoments top = nearest_symmetric_top(axes);
  if (top.asymmetry > tolerance) return {Model::full_body, "no two principal moments are equal"};
  if (std::abs(top.axial - top.transverse) > tolerance * std::max(top.axial, top.transverse))
    return {Model::symmetric_top, "two principal moments are equal"};
  return {Model::ball, "all principal moments are equal"};
}

}  // namespace tumble
