#pragma once
/// @file
/// A cylinder along z, its middle in the origin: V = π r² h, I_zz = m r²/2, I_xx = m (3r² + h²)/12.
///
/// Source: any table of moments of inertia, e.g. Meriam & Kraige, "Engineering Mechanics: Dynamics"
/// (7th ed. 2012), table D/4.

#include "tumble/mass/solids/solid_checks.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// A solid cylinder, x² + y² ≤ radius² and |z| ≤ height/2.
struct Cylinder {
  double radius = 1;  ///< [m]
  double height = 2;  ///< [m]

  bool contains(const Vec3& point) const {
    return point.head<2>().squaredNorm() <= radius * radius && 2 * std::abs(point.z()) <= height;
  }
  /// @throws std::invalid_argument if a dimension is not positive and finite
  Eigen::AlignedBox3d bounds() const {
    detail::require_positive(radius, "the cylinder's radius");
    detail::require_positive(height, "the cylinder's height");
    return {Vec3(-radius, -radius, -height / 2), Vec3(radius, radius, height / 2)};
  }
};

/// Mass properties of a homogeneous cylinder.
/// @param density [kg/m³]
/// @throws std::invalid_argument if a dimension or the density is not positive and finite
MassProperties mass_properties(const Cylinder& cylinder, double density);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/solids/cylinder.inl"
#endif
