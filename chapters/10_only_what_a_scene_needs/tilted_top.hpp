#pragma once
/// @file
/// A heavy top whose axis leans.

#include "common.hpp"

namespace scene_chapter {

/// A top on its pivot whose axis has no sideways velocity but this.
/// @param spin  about its own axis [rad/s]
/// @param tilt  of the axis against the vertical [rad]
/// @param round how fast the axis goes round the vertical at first [rad/s]
inline KnownTurning tilted_top(double spin, double tilt, double round) {
  const RigidBody<> body(1, Vec3(1, 1, 0.5).asDiagonal());
  const Quat q = turn({tilt, 0, 0});
  // round · e + (spin − round cos θ) n: about n the body turns by `spin`.
  const Vec3 up_in_body = q.conjugate() * Vec3::UnitZ();
  const Vec3 omega = round * up_in_body + (spin - round * std::cos(tilt)) * Vec3::UnitZ();
  return {body, turning_state(body, q, omega), held_weight(5, {0, 0, 1}), 0, q};
}

}  // namespace scene_chapter
