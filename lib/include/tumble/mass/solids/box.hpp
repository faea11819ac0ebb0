#pragma once
/// @file
/// A box along the axes, its middle in the origin: I_xx = m (b² + c²)/12.
///
/// Source: any table of moments of inertia, e.g. Meriam & Kraige, "Engineering Mechanics: Dynamics"
/// (7th ed. 2012), table D/4.

#include "tumble/mass/solids/solid_checks.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// A solid box, |x| ≤ size.x/2 and so on.
struct Box {
  Vec3 size = Vec3::Ones();  ///< full lengths of the edges [m]

  bool contains(const Vec3& point) const { return (2 * point.cwiseAbs() - size).maxCoeff() <= 0; }
  /// @throws std::invalid_argument if a length is not positive and finite
  Eigen::AlignedBox3d bounds() const {
    for (const double length : {size.x(), size.y(), size.z()})
      detail::require_positive(length, "the box's edge");
    return {-size / 2, size / 2};
  }
};

/// Mass properties of a homogeneous box.
/// @param density [kg/m³]
/// @throws std::invalid_argument if a length or the density is not positive and finite
MassProperties mass_properties(const Box& box, double density);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/solids/box.inl"
#endif
