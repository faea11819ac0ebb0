#pragma once
/// @file
/// What can push a rigid body: anything that, given the time and the motion, says with what wrench.
///
/// A user's own force is a lambda: [](double t, const RigidBody<>& body, const Derived<>& now)
/// { … }.

#include <cmath>
#include <concepts>
#include <tuple>

#include "tumble/body/derived.hpp"
#include "tumble/body/steady_forces.hpp"
#include "tumble/body/wrench.hpp"
#include "tumble/core/require.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// A callable (t, body, now) → Wrench<T>.
template <class F, class T>
concept BodyForce = requires(const F& force, T t, const RigidBody<T>& body, const Derived<T>& now) {
  { force(t, body, now) } -> std::convertible_to<Wrench<T>>;
};

/// Uniform gravity: m g at the centre of mass, hence no torque.
struct Weight {
  Vec3 g = {0, 0, -9.80665};  ///< [m/s²], standard gravity, z up

  template <class T>
  Wrench<T> operator()(T, const RigidBody<T>& body, const Derived<T>&) const {
    return {.force = body.mass() * g.cast<T>()};
  }
  SteadyForces steady(const RigidBody<>& body) const { return {.force = body.mass() * g}; }

  /// @throws std::invalid_argument if g is not finite
  void require_valid() const {
    require(g.allFinite(), "weight: g = (", g.transpose(), ") is not finite");
  }
};

/// A constant world force at a point that is fixed in the body.
struct ForceAtBodyPoint {
  Vec3 force;   ///< [N], world coordinates
  Vec3 p_body;  ///< where it acts [m], body coordinates

  template <class T>
  Wrench<T> operator()(T, const RigidBody<T>&, const Derived<T>& now) const {
    return force_at_point<T>(force.cast<T>(), point_position<T>(now, p_body.cast<T>()), now.x);
  }
  SteadyForces steady(const RigidBody<>&) const {
    return {.force = force, .at_point = {{force, p_body}}};
  }

  /// @throws std::invalid_argument if a number is not finite
  void require_valid() const {
    require(force.allFinite() && p_body.allFinite(), "force (", force.transpose(),
            ") at the point (", p_body.transpose(), "): not finite");
  }
};

/// Drag in proportion to velocity and to angular velocity: F = −linear v, τ = −angular ω.
struct BodyDrag {
  double linear;   ///< [kg/s]
  double angular;  ///< [kg m²/s]

  template <class T>
  Wrench<T> operator()(T, const RigidBody<T>&, const Derived<T>& now) const {
    return {-static_cast<T>(linear) * now.v, -static_cast<T>(angular) * now.omega};
  }
  SteadyForces steady(const RigidBody<>&) const {
    return {.linear_drag = linear, .angular_drag = angular};
  }

  /// @throws std::invalid_argument if a constant is negative or not finite
  void require_valid() const {
    for (const double constant : {linear, angular})
      require(constant >= 0 && std::isfinite(constant), "body drag: ", constant,
              " is not a finite number ≥ 0");
  }
};

/// A spring between a point of the body and a point of the world, with a damper beside it if one is
/// wanted. Where the points meet it has no direction and pulls with no force.
struct SpringToWorld {
  Vec3 p_body;         ///< [m], body coordinates
  Vec3 anchor;         ///< [m], world coordinates
  double stiffness;    ///< [N/m]
  double rest_length;  ///< [m]
  double damping = 0;  ///< of the damper, per speed at which the length grows [N s/m]

  template <class T>
  Wrench<T> operator()(T, const RigidBody<T>&, const Derived<T>& now) const {
    const Vector3<T> p = point_position<T>(now, p_body.cast<T>());
    const Vector3<T> l = anchor.cast<T>() - p;
    const T length = l.norm();
    if (length == T(0)) return {};
    T tension = static_cast<T>(stiffness) * (length - static_cast<T>(rest_length));
    if (damping != 0)
      tension -= static_cast<T>(damping) * point_velocity<T>(now, p_body.cast<T>()).dot(l) / length;
    return force_at_point<T>(tension / length * l, p, now.x);
  }

  /// @throws std::invalid_argument if a constant is negative, or a number is not finite
  void require_valid() const {
    require(p_body.allFinite() && anchor.allFinite(), "spring from (", p_body.transpose(), ") to (",
            anchor.transpose(), "): not finite");
    for (const double constant : {stiffness, rest_length, damping})
      require(constant >= 0 && std::isfinite(constant), "spring to the world: ", constant,
              " is not a finite number ≥ 0");
  }
};

namespace detail {

template <class Force>
void require_valid_force(const Force& force) {
  if constexpr (requires { force.require_valid(); }) force.require_valid();
}

/// The forces, each checked by its require_valid() if it has one.
/// @throws std::invalid_argument as they do
template <class... Forces>
std::tuple<Forces...> valid_forces(const Forces&... forces) {
  (require_valid_force(forces), ...);
  return {forces...};
}

}  // namespace detail

/// The sum of what all forces do; with no force at all, nothing is computed.
template <class T, BodyForce<T>... Forces>
Wrench<T> net_wrench(T t, const RigidBody<T>& body, const Derived<T>& now,
                     const std::tuple<Forces...>& forces) {
  const auto add = [&](const Forces&... force) {
    Wrench<T> sum;
    ((sum += force(t, body, now)), ...);
    return sum;
  };
  return std::apply(add, forces);
}

/// @}

}  // namespace tumble
