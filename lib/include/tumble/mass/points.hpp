#pragma once
/// @file
/// Mass properties of point masses: I = Σ m (rᵀr 1 − r rᵀ), r = x − c, c = Σ m x / Σ m.
///
/// The sums are taken about the first point and then moved, so bodies far away lose no digits.
/// Source: e.g. Goldstein, "Classical Mechanics" (3rd ed. 2002), eq. 5.8.

#include <span>

#include "tumble/mass/moments.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// A mass [kg] in one point [m].
struct PointMass {
  double mass = 0;
  Vec3 position = Vec3::Zero();
};

/// The centre of mass of points [m].
/// @throws std::invalid_argument as mass_properties() of points
Vec3 centre_of_mass(std::span<const PointMass> points);

/// Mass, centre and inertia of points. Points on one line have no inertia about it: the tensor is
/// then not one that a body can be simulated with (see require_valid_inertia()).
/// @throws std::invalid_argument if there are no points, a mass is negative or not finite, a
///         position is not finite, or all masses are 0
MassProperties mass_properties(std::span<const PointMass> points);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/points.inl"
#endif
