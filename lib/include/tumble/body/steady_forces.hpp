#pragma once
/// @file
/// Forces that keep their direction and size in the world and act at fixed points of a body, and
/// drag in proportion to v and ω. The path of the centre is then a closed form, and the turning
/// does not depend on it.

#include <cmath>
#include <concepts>
#include <vector>

#include "tumble/body/derived.hpp"
#include "tumble/body/wrench.hpp"
#include "tumble/core/require.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// The sum of steady forces on a body; a BodyForce itself, for those that are known only when a
/// program runs.
struct SteadyForces {
  /// A constant force and where it acts.
  struct AtPoint {
    Vec3 force;   ///< [N], world coordinates
    Vec3 p_body;  ///< [m], body coordinates
  };

  Vec3 force = Vec3::Zero();           ///< all constant forces together [N]
  std::vector<AtPoint> at_point = {};  ///< those of them that may turn the body
  double linear_drag = 0;              ///< k in F = −k v [kg/s]
  double angular_drag = 0;             ///< k in τ = −k ω [kg m²/s]

  template <class T>
  Wrench<T> operator()(T, const RigidBody<T>&, const Derived<T>& now) const {
    Wrench<T> sum{force.cast<T>() - static_cast<T>(linear_drag) * now.v,
                  -static_cast<T>(angular_drag) * now.omega};
    for (const AtPoint& f : at_point)
      sum.torque += Vector3<T>(now.R * f.p_body.cast<T>()).cross(f.force.cast<T>());
    return sum;
  }
  const SteadyForces& steady(const RigidBody<>&) const { return *this; }

  /// @throws std::invalid_argument if a number is not finite, or a drag negative
  void require_valid() const {
    require(force.allFinite(), "steady forces: the force (", force.transpose(), ") is not finite");
    for (std::size_t i = 0; i < at_point.size(); ++i)
      require(at_point[i].force.allFinite() && at_point[i].p_body.allFinite(),
              "steady forces: at_point[", i, "]: the force (", at_point[i].force.transpose(),
              ") at the point (", at_point[i].p_body.transpose(), ") is not finite");
    require(linear_drag >= 0 && std::isfinite(linear_drag),
            "steady forces: linear_drag = ", linear_drag, " is not a finite number ≥ 0");
    require(angular_drag >= 0 && std::isfinite(angular_drag),
            "steady forces: angular_drag = ", angular_drag, " is not a finite number ≥ 0");
  }

  friend SteadyForces operator+(SteadyForces a, const SteadyForces& b) {
    a.force += b.force;
    a.at_point.insert(a.at_point.end(), b.at_point.begin(), b.at_point.end());
    a.linear_drag += b.linear_drag;
    a.angular_drag += b.angular_drag;
    return a;
  }
};

namespace detail {

/// A force that says what it amounts to: `force.steady(body)`.
template <class F>
concept SteadyForce = requires(const F& force, const RigidBody<>& body) {
  { force.steady(body) } -> std::convertible_to<SteadyForces>;
};

/// What all of them amount to.
template <SteadyForce... Forces>
SteadyForces steady_forces(const RigidBody<>& body, const Forces&... forces) {
  return (SteadyForces{} + ... + forces.steady(body));
}

}  // namespace detail

/// @}

}  // namespace tumble
