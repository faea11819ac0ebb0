#pragma once
/// @file
/// What the motion of a rigid body needs to know about its shape and material: ten numbers.

#include <limits>

#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// Mass, centre of mass and inertia tensor of a body, in the coordinates the shape was given in.
/// A default-constructed value is all NaN: nothing has been computed yet.
struct MassProperties {
  double mass = std::numeric_limits<double>::quiet_NaN();                  ///< [kg]
  Vec3 centre = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  ///< centre of mass [m]
  /// Inertia tensor about the centre of mass [kg m²], products with the minus sign (I_xy = −∫
  /// x y dm).
  Mat3 inertia = Mat3::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// @}

}  // namespace tumble
