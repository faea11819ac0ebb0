#pragma once
/// @file
/// A cone along z, its base in the plane z = 0: V = π r² h/3, centre of mass at z = h/4,
/// I_zz = 3/10 m r², I_xx = 3/80 m (4r² + h²) about the centre of mass.
///
/// Source: any table of moments of inertia, e.g. Meriam & Kraige, "Engineering Mechanics: Dynamics"
/// (7th ed. 2012), table D/4.

#include "tumble/mass/solids/solid_checks.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// A solid cone with its base around the origin and its tip at z = height.
struct Cone {
  double radius = 1;  ///< of the base [m]
  double height = 2;  ///< [m]

  bool contains(const Vec3& point) const {
    const double across = radius * (1 - point.z() / height);
    return point.z() >= 0 && point.z() <= height &&
           point.head<2>().squaredNorm() <= across * across;
  }
  /// @throws std::invalid_argument if a dimension is not positive and finite
  Eigen::AlignedBox3d bounds() const {
    detail::require_positive(radius, "the cone's radius");
    detail::require_positive(height, "the cone's height");
    return {Vec3(-radius, -radius, 0), Vec3(radius, radius, height)};
  }
};

/// Mass properties of a homogeneous cone.
/// @param density [kg/m³]
/// @throws std::invalid_argument if a dimension or the density is not positive and finite
MassProperties mass_properties(const Cone& cone, double density);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/solids/cone.inl"
#endif
