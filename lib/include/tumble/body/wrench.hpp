#pragma once
/// @file
/// Force and torque together: what pushes a body.
///
/// τ = (p − x) × F.   Source: Baraff, "Rigid Body Simulation I" (1997), §2.7.

#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// A force and the torque about the centre of mass, in world coordinates.
template <class T = double>
struct Wrench {
  Vector3<T> force = Vector3<T>::Zero();   ///< [N]
  Vector3<T> torque = Vector3<T>::Zero();  ///< about the centre of mass [N m]

  bool operator==(const Wrench&) const = default;

  Wrench& operator+=(const Wrench& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
  friend Wrench operator+(Wrench a, const Wrench& b) { return a += b; }
};

/// The wrench of a force F [N] at the world point p [m] on a body with its centre of mass at x [m].
template <class T>
Wrench<T> force_at_point(const Vector3<T>& F, const Vector3<T>& p, const Vector3<T>& x) {
  return {.force = F, .torque = (p - x).cross(F)};
}

/// @}

}  // namespace tumble
