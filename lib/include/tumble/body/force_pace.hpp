#pragma once
/// @file
/// How fast springs and drags answer to a motion: what no integration could follow is refused by
/// its name and number, and what could be followed is said.

#include <cmath>
#include <iomanip>
#include <span>
#include <string>
#include <vector>

#include "tumble/body/forces.hpp"
#include "tumble/body/forces_between.hpp"
#include "tumble/body/held_body.hpp"
#include "tumble/rotation/skew.hpp"

namespace tumble::detail {

/// A constant of a force, and how fast what it drives swings, or comes to rest.
struct ForcePace {
  const char* constant;  ///< "the stiffness"
  const char* unit;
  double value;
  double rate;   ///< [1/s]
  double power;  ///< the value is in proportion to this power of the rate

  /// About what the value may be for a motion of this length [s]. A run takes a million steps, some
  /// ten per radian.
  double possible(double span) const {
    constexpr double radians = 1e5;
    const double exact = value * std::pow(radians / (rate * span), power);
    return std::pow(10, std::floor(std::log10(exact)));
  }

  std::string advice(double span) const {
    return text_of(std::setprecision(3), constant, ' ', value, ' ', unit, " makes it move within ",
                   1 / rate, " s. To follow it for ", span, " s, give about ", possible(span), ' ',
                   unit, " at most, or ask for a shorter time");
  }
};

/// By how much velocity a push at a point changes the point's velocity, at most about [1/kg].
/// @param p_body [m], from the centre of mass
inline double mobility(const RigidBody<>& body, const Vec3& p_body) {
  const Mat3 p = rotation::skew(p_body);
  return 1 / body.mass() + (p * body.I_body_inv() * p.transpose()).trace();
}
inline double mobility(const HeldBody& held, const Vec3& p_body) {
  const Mat3 p = rotation::skew(Vec3(p_body - held.held()));
  return (p * held.about_point().I_body_inv() * p.transpose()).trace();
}

/// What turns: the body, or the body about the point where it is held.
inline const RigidBody<>& turning(const RigidBody<>& body) { return body; }
inline const RigidBody<>& turning(const HeldBody& held) { return held.about_point(); }

/// How long the lever of a force at a point is, at most [m].
inline double lever(const RigidBody<>&, const Vec3& p_body) { return p_body.norm(); }
inline double lever(const HeldBody& held, const Vec3& p_body) {
  return (p_body - held.held()).norm();
}

using ForcePaces = std::vector<ForcePace>;

/// @param per_mass of what hangs on the spring [1/kg]
inline ForcePaces spring_paces(double stiffness, double damping, double per_mass) {
  return {{"the stiffness", "N/m", stiffness, std::sqrt(stiffness * per_mass), 2},
          {"the damping", "N s/m", damping, damping * per_mass, 1}};
}

/// @tparam Body RigidBody<> or HeldBody
template <class Body>
ForcePaces paces(const SpringToWorld& spring, const Body& body) {
  return spring_paces(spring.stiffness, spring.damping, mobility(body, spring.p_body));
}
inline ForcePaces paces(const SpringBetween& spring, std::span<const RigidBody<>> bodies) {
  if (spring.a >= bodies.size() || spring.b >= bodies.size()) return {};  // refused by the spring
  return spring_paces(
      spring.stiffness, spring.damping,
      mobility(bodies[spring.a], spring.p_a) + mobility(bodies[spring.b], spring.p_b));
}
template <class Body>
ForcePaces paces(const SteadyForces& steady, const Body& body) {
  const double per_moment = turning(body).I_body_inv().norm();
  ForcePaces all = {
      {"the linear drag", "kg/s", steady.linear_drag,
       steady.linear_drag * mobility(body, Vec3::Zero()), 1},
      {"the angular drag", "kg m²/s", steady.angular_drag, steady.angular_drag * per_moment, 1}};
  const auto pull = [&](const Vec3& force, const Vec3& p_body) {
    const double F = force.norm(), torque = F * lever(body, p_body);
    all.push_back({"the force", "N", F, std::sqrt(torque * per_moment), 2});
  };
  pull(steady.force, Vec3::Zero());
  for (const auto& [force, p_body] : steady.at_point) pull(force, p_body);
  return all;
}
template <class Body>
ForcePaces paces(const BodyDrag& drag, const Body& body) {
  return paces(SteadyForces{.linear_drag = drag.linear, .angular_drag = drag.angular}, body);
}

/// Refuses a force that swings or decays far more often in a time than a run has steps.
/// @param span [s]
/// @throws std::invalid_argument with the constant, and with one that is possible
template <class Force, class Body>
void require_followable([[maybe_unused]] const Force& force, [[maybe_unused]] const Body& body,
                        [[maybe_unused]] double span) {
  constexpr double hopeless = 1e12;
  if constexpr (requires { paces(force, body); })
    for (const ForcePace& pace : paces(force, body))
      if (pace.rate * span > hopeless) refuse("simulate: ", pace.advice(span));
}

}  // namespace tumble::detail
