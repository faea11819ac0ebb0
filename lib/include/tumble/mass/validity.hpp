#pragma once
/// @file
/// Which tensors some body has as its inertia, and refusing those that none has.
///
/// With the principal moments A ≤ B ≤ C: A > 0 and A + B ≥ C, because A + B − C = 2 ∫ z² dm ≥ 0.
/// Equality is a flat body (a lamina), which is allowed.
/// Source: e.g. Wittenburg, "Dynamics of Multibody Systems" (2nd ed. 2008), §3.1.2.

#include <cmath>
#include <iomanip>
#include <string>

#include "tumble/core/require.hpp"
#include "tumble/mass/as_point.hpp"
#include "tumble/mass/mass_properties.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

namespace detail {

/// How far rounding alone may take a good tensor from the laws, in units of its trace.
///
/// A tensor arrives as R I Rᵀ: two products of three terms round by 2·3·3 eps, an R that is a
/// rotation up to 4 eps adds 8 eps, finding the principal moments about 6 eps; together 32 eps.
inline constexpr double inertia_rounding = 32 * 0x1p-53;

/// What is wrong with an inertia tensor, in words and numbers; empty if nothing is.
/// @param I 3×3 [kg m²]
inline std::string inertia_defect(const Mat3& I) {
  using detail::text_of;
  const auto exactly = std::setprecision(17);
  const double allowance = detail::inertia_rounding * I.trace();
  if (!I.allFinite()) return text_of(exactly, "has an entry that is not a finite number:\n", I);
  const double skewed = (I - I.transpose()).cwiseAbs().maxCoeff();
  if (skewed > std::abs(allowance))
    return text_of(exactly, "is not symmetric: it differs from its transpose by ", skewed);
  const Vec3 moments = principal_axes(I).moments;
  if (!(moments[0] > 0))
    return text_of(exactly, "is not positive definite: its principal moments are ",
                   detail::AsPoint{moments});
  if (moments[2] - moments[1] - moments[0] > allowance)
    return text_of(exactly, "breaks the triangle inequality: the principal moments ", moments[0],
                   " + ", moments[1], " are less than ", moments[2], ", so no body has it");
  return {};
}

/// Whether some body has this inertia tensor (up to rounding).
inline bool is_valid_inertia(const Mat3& I) { return inertia_defect(I).empty(); }

/// Refuses an inertia tensor that no body has.
/// @throws std::invalid_argument saying which condition fails, with numbers: not finite, not
///         symmetric, not positive definite, triangle inequality broken
inline void require_valid_inertia(const Mat3& I) {
  const std::string defect = inertia_defect(I);
  require(defect.empty(), "the inertia tensor ", defect);
}

}  // namespace detail

/// Refuses mass properties that no body has.
/// @throws std::invalid_argument if the mass is not a positive finite number, the centre is not
///         finite, or the inertia tensor is one that no body has
inline void require_valid(const MassProperties& body) {
  require(body.mass > 0 && std::isfinite(body.mass), "the mass ", body.mass,
          " kg is not a positive finite number");
  require(body.centre.allFinite(), "the centre of mass ", detail::AsPoint{body.centre},
          " is not finite");
  detail::require_valid_inertia(body.inertia);
}

/// @}

}  // namespace tumble
