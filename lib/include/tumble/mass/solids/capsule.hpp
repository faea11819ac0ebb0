#pragma once
/// @file
/// A capsule along z, its middle in the origin: a cylinder with a hemisphere at each end.
///
/// With m_c the cylinder's mass and m_s that of both hemispheres: I_zz = m_c r²/2 + ⅖ m_s r²,
/// I_xx = m_c (3r² + h²)/12 + m_s (⅖ r² + h²/4 + ⅜ h r): a hemisphere's centre is ⅜ r from its
/// base. Source: the parts from Meriam & Kraige, "Engineering Mechanics: Dynamics" (7th ed. 2012),
/// table D/4, joined by the parallel axis theorem.

#include "tumble/mass/solids/solid_checks.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// All points within radius of the segment from (0, 0, −height/2) to (0, 0, height/2).
struct Capsule {
  double radius = 1;  ///< [m]
  double height = 2;  ///< of the cylinder between the hemispheres; 0 is a ball [m]

  bool contains(const Vec3& point) const {
    const double beyond = std::max(0.0, std::abs(point.z()) - height / 2);
    return point.head<2>().squaredNorm() + beyond * beyond <= radius * radius;
  }
  /// @throws std::invalid_argument if the radius is not positive or the height negative or not
  ///         finite
  Eigen::AlignedBox3d bounds() const {
    detail::require_positive(radius, "the capsule's radius");
    require(height >= 0 && std::isfinite(height), "the capsule's height is ", height,
            ", negative or not finite");
    const Vec3 corner(radius, radius, radius + height / 2);
    return {-corner, corner};
  }
};

/// Mass properties of a homogeneous capsule.
/// @param density [kg/m³]
/// @throws std::invalid_argument if a dimension or the density is wrong
MassProperties mass_properties(const Capsule& capsule, double density);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/solids/capsule.inl"
#endif
