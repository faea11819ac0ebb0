#pragma once
/// @file
/// Gravity near the ground:
///
///     F = m g

#include "tumble/core/require.hpp"
#include "tumble/particles/particle.hpp"

namespace tumble::particles {

/// @addtogroup particles
/// @{

/// The same acceleration for every particle.
struct UniformGravity {
  Vec3 g;  ///< [m/s²]

  /// The force on a particle [N].
  template <class T>
  Vector3<T> operator()(T, const Particle<T>& particle) const {
    return particle.mass * g.cast<T>();
  }

  /// @throws std::invalid_argument if g is not finite
  void require_valid(int) const {
    require(g.allFinite(), "gravity: g = (", g.transpose(), ") is not finite");
  }
};

/// @}

}  // namespace tumble::particles
