#pragma once
/// @file
/// A die of plastic that leaves a hand over a table.

#include <numbers>

#include "tumble/body/rigid_body.hpp"
#include "tumble/body/state.hpp"

namespace tumble::objects {

inline constexpr double die_edge = 0.016, plastic = 1200;  // [m], [kg/m³]

inline RigidBody<> die() {
  const double mass = plastic * die_edge * die_edge * die_edge;
  return {mass, mass * die_edge * die_edge / 6 * Mat3::Identity()};
}

/// 9 cm above the table, lying as it happens to lie.
inline RigidBodyState<> die_in_hand(const Vec3& v, const Vec3& omega) {
  const RigidBody<> body = die();
  return {
      {0, 0, 0.09}, Quat(0.9, 0.3, 0.2, 0.25).normalized(), body.mass() * v, body.I_body() * omega};
}

/// Thrown forwards and up, with three turns per second.
inline RigidBodyState<> thrown_die() {
  return die_in_hand({0.5, 0, 0.4}, {10, 6 * std::numbers::pi, 4});
}

}  // namespace tumble::objects
