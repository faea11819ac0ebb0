#pragma once
/// @file
/// What bodies do to each other.
///
/// A force of your own between bodies is a lambda that adds to their wrenches:
/// [](double t, std::span<const RigidBody<>> bodies, std::span<const Derived<>> now,
///    std::span<Wrench<>> net) { … }.

#include <cmath>
#include <cstddef>
#include <span>

#include "tumble/body/derived.hpp"
#include "tumble/body/wrench.hpp"
#include "tumble/core/require.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// A spring between points of two bodies, with a damper beside it if one is wanted. Where the
/// points meet it has no direction and pulls with no force. Momentum and angular momentum of both
/// together stay as they are.
struct SpringBetween {
  std::size_t a, b;    ///< numbers of the bodies in their scene, from 0
  Vec3 p_a, p_b;       ///< [m], body coordinates of a and of b
  double stiffness;    ///< [N/m]
  double rest_length;  ///< [m]
  double damping = 0;  ///< of the damper, per speed at which the length grows [N s/m]

  /// @throws std::invalid_argument if there is no body a or b
  template <class T>
  void operator()(T, std::span<const RigidBody<T>> bodies, std::span<const Derived<T>> now,
                  std::span<Wrench<T>> net) const {
    require(a < bodies.size() && b < bodies.size(), "spring between the bodies ", a, " and ", b,
            ": there are ", bodies.size(), " bodies, counted from 0");
    const Vector3<T> at_a = point_position<T>(now[a], p_a.cast<T>()),
                     at_b = point_position<T>(now[b], p_b.cast<T>());
    const Vector3<T> l = at_b - at_a;
    const T length = l.norm();
    if (length == T(0)) return;
    T tension = static_cast<T>(stiffness) * (length - static_cast<T>(rest_length));
    if (damping != 0) {
      const Vector3<T> v =
          point_velocity<T>(now[b], p_b.cast<T>()) - point_velocity<T>(now[a], p_a.cast<T>());
      tension += static_cast<T>(damping) * v.dot(l) / length;
    }
    const Vector3<T> pull = tension / length * l;
    net[a] += force_at_point<T>(pull, at_a, now[a].x);
    net[b] += force_at_point<T>(-pull, at_b, now[b].x);
  }

  /// @throws std::invalid_argument if it joins a body to itself, a constant is negative, or a
  /// number
  ///         is not finite
  void require_valid() const {
    require(a != b, "spring between bodies: it joins body ", a, " to itself");
    require(p_a.allFinite() && p_b.allFinite(), "spring between the points (", p_a.transpose(),
            ") and (", p_b.transpose(), "): not finite");
    for (const double constant : {stiffness, rest_length, damping})
      require(constant >= 0 && std::isfinite(constant), "spring between bodies: ", constant,
              " is not a finite number ≥ 0");
  }
};

/// @}

}  // namespace tumble
