#pragma once
/// @file
/// Which way friction points while a contact lasts: against the slip, and where there is none, so
/// that none begins, if μ allows it.
///
/// All in the contact's own axes: two along the surface, the third one along the normal.

#include "tumble/core/types.hpp"

namespace tumble::contact::detail {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

/// Friction per normal impulse that keeps a contact at rest: K_tt f + K_tn = 0.
Vec2 holding_friction(const Mat3& K);

/// The direction in which a contact begins to slide that friction cannot hold: the one in which it
/// is accelerated, K_tn − μ K_tt s = λ s with λ > 0. There is exactly one: |(λ + μ K_tt)⁻¹ K_tn|
/// falls with λ, and is above 1 at λ = 0 because μ does not suffice. Source for its being unique:
/// Batlle, "Rough balanced collisions", J. Applied Mechanics 63 (1996).
Vec2 direction_of_escape(const Mat3& K, double mu);

/// What presses per normal impulse: friction and the normal itself.
inline Vec3 pressing(const Vec2& friction) { return {friction.x(), friction.y(), 1}; }

/// The size of the velocities that add up to a slip [m/s].
inline double speed_scale(const Mat3& K, const Vec3& u, const Vec3& j) {
  return u.norm() + K.norm() * j.norm();
}

}  // namespace tumble::contact::detail

#ifndef TUMBLE_COMPILED
#include "tumble/contact/friction_cone.inl"
#endif
