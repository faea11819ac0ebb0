#pragma once
/// @file
/// What can push a rigid body: anything that, given the time and the motion, says with what wrench.
///
/// A user's own force is a lambda: [](double t, const RigidBody<>& body, const Derived<>& now) { …
/// }.

#include <concepts>
#include <tuple>

#include "tumble/body/derived.hpp"
#include "tumble/body/wrench.hpp"

namespace tumble {

/// A callable (t, body, now) → Wrench<T>.
template <class F, class T>
concept BodyForce = requires(const F& force, T t, const RigidBody<T>& body, const Derived<T>& now) {
  { force(t, body, now) } -> std::convertible_to<Wrench<T>>;
};

/// Uniform gravity: m g at the centre of mass, hence no torque.
template <class T = double>
struct Weight {
  Vector3<T> g = Vector3<T>(T(0), T(0), T(-9.80665));  ///< [m/s²], standard gravity, z up
  Wrench<T> operator()(T, const RigidBody<T>& body, const Derived<T>&) const {
    return {body.mass() * g, Vector3<T>::Zero()};
  }
};

/// A constant world force at a point that is fixed in the body.
template <class T = double>
struct ForceAtBodyPoint {
  Vector3<T> force;   ///< [N], world coordinates
  Vector3<T> p_body;  ///< where it acts [m], body coordinates
  Wrench<T> operator()(T, const RigidBody<T>&, const Derived<T>& now) const {
    return force_at_point<T>(force, point_position(now, p_body), now.x);
  }
};

/// Drag in proportion to velocity and to angular velocity: F = −k v, τ = −k_spin ω.
template <class T = double>
struct BodyDrag {
  T k;       ///< [kg/s]
  T k_spin;  ///< [kg m²/s]
  Wrench<T> operator()(T, const RigidBody<T>&, const Derived<T>& now) const {
    return {-k * now.v, -k_spin * now.omega};
  }
};

/// A spring between a point of the body and a point of the world; none at zero length.
template <class T = double>
struct SpringToWorld {
  Vector3<T> p_body;  ///< [m], body coordinates
  Vector3<T> anchor;  ///< [m], world coordinates
  T stiffness;        ///< [N/m]
  T rest_length;      ///< [m]
  Wrench<T> operator()(T, const RigidBody<T>&, const Derived<T>& now) const {
    const Vector3<T> p = point_position(now, p_body);
    const Vector3<T> d = anchor - p;
    const T length = d.norm();
    if (length == T(0)) return {};
    return force_at_point<T>((stiffness * (length - rest_length) / length) * d, p, now.x);
  }
};

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

}  // namespace tumble
