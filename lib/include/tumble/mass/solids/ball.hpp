#pragma once
/// @file
/// A ball, its middle in the origin: V = 4π/3 r³, I = ⅖ m r² 1.
///
/// Source: any table of moments of inertia, e.g. Meriam & Kraige, "Engineering Mechanics: Dynamics"
/// (7th ed. 2012), table D/4.

#include "tumble/mass/solids/solid_checks.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// A solid ball, |x| ≤ radius.
struct Ball {
  double radius = 1;  ///< [m]

  bool contains(const Vec3& point) const { return point.squaredNorm() <= radius * radius; }
  /// @throws std::invalid_argument if the radius is not positive and finite
  Eigen::AlignedBox3d bounds() const {
    detail::require_positive(radius, "the ball's radius");
    return {Vec3::Constant(-radius), Vec3::Constant(radius)};
  }
};

/// Mass properties of a homogeneous ball.
/// @param density [kg/m³]
/// @throws std::invalid_argument if the radius or the density is not positive and finite
MassProperties mass_properties(const Ball& ball, double density);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/solids/ball.inl"
#endif
