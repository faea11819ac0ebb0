#pragma once
/// @file
/// Which tensors some body has as its inertia, and refusing those that none has.
///
/// With the principal moments A ≤ B ≤ C: A > 0 and A + B ≥ C, because A + B − C = 2 ∫ z² dm ≥ 0.
/// Equality is a flat body (a lamina), which is allowed.
/// Source: e.g. Wittenburg, "Dynamics of Multibody Systems" (2nd ed. 2008), §3.1.2.

#include <string>

#include "tumble/core/require.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/mass/mass_properties.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

namespace detail {

/// How far rounding alone may take a good tensor from the laws, in units of its trace.
///
/// A tensor arrives as R I Rᵀ: two products of three terms round by 2·3·3 eps, an R that is a
/// rotation up to 4 eps adds 8 eps, finding the principal moments about 6 eps; together 32 eps.
inline constexpr double inertia_rounding = 32 * unit_roundoff;

/// What is wrong with an inertia tensor, in words and numbers; empty if nothing is.
/// @param I 3×3 [kg m²]
std::string inertia_defect(const Mat3& I);

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
void require_valid(const MassProperties& body);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/validity.inl"
#endif
