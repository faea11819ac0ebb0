#pragma once
/// @file
/// Resistance of what the particles move through.
///
///     slow, viscous:  F = −k v        fast, turbulent:  F = −k |v| v
///
/// Source: Witkin & Baraff, "Physically Based Modeling", SIGGRAPH course notes (2001), "Particle
/// System Dynamics", section 4.1; Goldstein, Poole & Safko, "Classical Mechanics", 3rd ed., 1.5.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/particles/particle.hpp"

namespace tumble::particles {

/// @addtogroup particles
/// @{

/// Drag in proportion to the speed.
struct LinearDrag {
  double k;  ///< [kg/s]

  /// The force on a particle [N].
  template <class T>
  Vector3<T> operator()(T, const Particle<T>& particle) const {
    return -static_cast<T>(k) * particle.v;
  }

  /// @throws std::invalid_argument if k is negative or not finite
  void require_valid(int) const {
    require(k >= 0 && std::isfinite(k), "linear drag: k = ", k, " is not a finite number ≥ 0");
  }
};

/// Drag in proportion to the square of the speed.
struct QuadraticDrag {
  double k;  ///< ½ ρ c_d A [kg/m]

  /// The force on a particle [N].
  template <class T>
  Vector3<T> operator()(T, const Particle<T>& particle) const {
    return -static_cast<T>(k) * particle.v.norm() * particle.v;
  }

  /// @throws std::invalid_argument if k is negative or not finite
  void require_valid(int) const {
    require(k >= 0 && std::isfinite(k), "quadratic drag: k = ", k, " is not a finite number ≥ 0");
  }
};

/// @}

}  // namespace tumble::particles
