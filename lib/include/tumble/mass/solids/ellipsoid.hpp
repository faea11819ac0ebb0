#pragma once
/// @file
/// An ellipsoid along the axes, its middle in the origin: V = 4π/3 abc, I_xx = m (b² + c²)/5.
///
/// Source: any table of moments of inertia, e.g. Meriam & Kraige, "Engineering Mechanics: Dynamics"
/// (7th ed. 2012), table D/4.

#include "tumble/mass/solids/solid_checks.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// A solid ellipsoid, (x/a)² + (y/b)² + (z/c)² ≤ 1.
struct Ellipsoid {
  Vec3 radii = Vec3::Ones();  ///< half axes a, b, c [m]

  bool contains(const Vec3& point) const { return point.cwiseQuotient(radii).squaredNorm() <= 1; }
  /// @throws std::invalid_argument if a half axis is not positive and finite
  Eigen::AlignedBox3d bounds() const {
    for (const double r : {radii.x(), radii.y(), radii.z()})
      detail::require_positive(r, "the ellipsoid's half axis");
    return {-radii, radii};
  }
};

/// Mass properties of a homogeneous ellipsoid.
/// @param density [kg/m³]
/// @throws std::invalid_argument if a half axis or the density is not positive and finite
MassProperties mass_properties(const Ellipsoid& ellipsoid, double density);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/solids/ellipsoid.inl"
#endif
