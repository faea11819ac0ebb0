#pragma once
/// @file
/// A point with a mass: all that moves, as long as nothing has a shape.
///
/// Source: Witkin & Baraff, "Physically Based Modeling", SIGGRAPH course notes (2001), "Particle
/// System Dynamics", section 2.

#include <limits>

#include "tumble/core/types.hpp"

namespace tumble::particles {

/// @addtogroup particles
/// @{

/// A particle, with NaN for what has not been said.
template <class T = double>
struct Particle {
  T mass = std::numeric_limits<T>::quiet_NaN();                              ///< [kg]
  Vector3<T> x = Vector3<T>::Constant(std::numeric_limits<T>::quiet_NaN());  ///< position [m]
  Vector3<T> v = Vector3<T>::Constant(std::numeric_limits<T>::quiet_NaN());  ///< velocity [m/s]
};

/// @}

}  // namespace tumble::particles
