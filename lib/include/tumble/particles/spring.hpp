#pragma once
/// @file
/// A damped spring between two particles.
///
///     l = xᵢ − xⱼ,   Fᵢ = −(k (|l| − r) + d l̇·l/|l|) l/|l|,   Fⱼ = −Fᵢ
///
/// Source: Witkin & Baraff, "Physically Based Modeling", SIGGRAPH course notes (2001), "Particle
/// System Dynamics", eq. 1.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/particles/force.hpp"

namespace tumble::particles {

/// @addtogroup particles
/// @{

/// A spring between particles i and j. Where they are at the same place it has no direction and
/// pulls with no force.
struct Spring {
  int i, j;
  double stiffness;    ///< k [N/m]
  double damping;      ///< d [N s/m], along the spring only
  double rest_length;  ///< r [m]

  /// Pushes both ends.
  template <class T>
  void operator()(T, const ParticlesView<T>& particles, const ForceSums<T>& push) const {
    const Vector3<T> l = particles.x(i) - particles.x(j);
    const T length = l.norm();
    if (length == 0) return;
    const Vector3<T> direction = l / length;
    const T stretching = (particles.v(i) - particles.v(j)).dot(direction);
    const T tension = static_cast<T>(stiffness) * (length - static_cast<T>(rest_length)) +
                      static_cast<T>(damping) * stretching;
    push(i, -tension * direction);
    push(j, tension * direction);
  }

  /// @throws std::invalid_argument if i or j is none of n particles or both are the same, or a
  ///         constant is negative or not finite
  void require_valid(int n) const {
    for (const int end : {i, j})
      require(0 <= end && end < n, "spring: there is no particle ", end, " among ", n);
    require(i != j, "spring: both ends are particle ", i);
    const auto valid = [](double value) { return value >= 0 && std::isfinite(value); };
    require(valid(stiffness), "spring ", i, "–", j, ": stiffness = ", stiffness,
            " is not a finite number ≥ 0");
    require(valid(damping), "spring ", i, "–", j, ": damping = ", damping,
            " is not a finite number ≥ 0");
    require(valid(rest_length), "spring ", i, "–", j, ": rest_length = ", rest_length,
            " is not a finite number ≥ 0");
  }
};

/// @}

}  // namespace tumble::particles
