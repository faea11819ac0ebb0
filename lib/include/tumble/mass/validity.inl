#pragma once

#include "tumble/mass/validity.hpp"

#include <cmath>
#include <iomanip>

#include "tumble/core/compiled.hpp"
#include "tumble/mass/as_point.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::detail {

TUMBLE_BODY std::string inertia_defect(const Mat3& I) {
  using detail::text_of;
  const auto readable = std::setprecision(9);
  const double allowance = detail::inertia_rounding * I.trace();
  if (!I.allFinite()) return text_of(readable, "has an entry that is not a finite number:\n", I);
  const double skewed = (I - I.transpose()).cwiseAbs().maxCoeff();
  if (skewed > std::abs(allowance))
    return text_of(readable, "is not symmetric: it differs from its transpose by ", skewed);
  const Vec3 moments = principal_axes(I).moments;
  if (!(moments[0] > 0))
    return text_of(readable, "is not positive definite: its principal moments are ",
                   detail::AsPoint{moments});
  const double excess = moments[2] - moments[1] - moments[0];
  if (excess > allowance)  // it may be smaller than the digits of the moments show
    return text_of(readable, "breaks the triangle inequality: the principal moments ", moments[0],
                   " + ", moments[1], " are less than ", moments[2], ", by ", std::setprecision(2),
                   excess, ", so no body has it");
  return {};
}

}  // namespace tumble::detail

namespace tumble {

TUMBLE_BODY void require_valid(const MassProperties& body) {
  require(body.mass > 0 && std::isfinite(body.mass), "the mass ", body.mass,
          " kg is not a positive finite number");
  require(body.centre.allFinite(), "the centre of mass ", detail::AsPoint{body.centre},
          " is not finite");
  detail::require_valid_inertia(body.inertia);
}

}  // namespace tumble
