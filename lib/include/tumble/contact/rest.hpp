#pragma once
/// @file
/// When bounces become so low that a body stays in touch with a floor, and how it goes on then.
///
/// With e < 1 bounces add up to a finite time. Of a ball that is a geometric series, and it rests
/// or rolls from then on. Of other bodies one corner stays down first, while the others still turn
/// about it: see hops.hpp.

#include <cmath>

#include "tumble/contact/several_points.hpp"

namespace tumble::contact::detail {

/// A contact and its impulses.
struct Aftermath {
  Vec3 normal;     ///< out of what it hit
  double coming;   ///< the speed at which the fastest of its points came [m/s]
  double parting;  ///< the least speed at which one leaves [m/s]
  double first;    ///< the largest speed at which this body has landed since it last stood [m/s]
};

/// Whether the bodies part with a billionth of the speed with which they came first.
inline bool has_faded(const Aftermath& after) { return after.parting <= 1e-9 * after.first; }

/// Whether they also came with no more: then they stay in touch, without anything that pulls.
inline bool stays(const Aftermath& after) {
  return has_faded(after) && after.coming <= 1e-9 * after.first;
}

/// The time that all bounces still take [s]: the sum of 2 u/g e^k.
inline double time_to_rest(double parting, double pull, double e) {
  return e < 1 ? 2 * std::fmax(0, parting) / (pull * (1 - e)) : 0;
}

/// Whether a ball that stays on the ground rolls on as it is: it does not slip, or nothing rubs,
/// and the ground is level.
bool rolls_on(const Colliding& ball, double radius, const Vec3& normal, const Vec3& gravity,
              double mu);

/// The same without a speed along the normal.
inline RigidBodyState<> along_ground(RigidBodyState<> state, const Vec3& normal) {
  state.P -= normal.dot(state.P) * normal;
  return state;
}

/// What a body on the ground may still have and count as being at rest.
struct Stillness {
  double lift;   ///< energy for hops so high, as a part of its reach
  double speed;  ///< along the ground; what has more has to be stopped by friction [m/s]
  double near;  ///< so close to the ground are the points that it stands on, as a part of its reach
};

/// How fast a body on the ground slides along it, or turns about its normal [m/s].
inline double speed_along(const Colliding& c, double reach, const Vec3& normal) {
  const Derived<> now = derived(c.body, c.state);
  return (now.v - now.v.dot(normal) * normal).norm() + std::abs(now.omega.dot(normal)) * reach;
}

/// Whether a body stands on the ground as it lies there: the line through its centre along `pull`,
/// which is gravity less the body's own acceleration, meets the ground between its feet. A ball
/// stands on one point, and rolls with the least push.
/// @param normal out of the ground
/// @param near   so close to the ground are its feet [m]
bool stands_on(const Colliding& c, const collide::Convex& shape, const Vec3& normal,
               const Vec3& pull, double near);

/// Whether a body on the ground is at rest there: it has no energy to tilt, nothing goes on that
/// friction does not stop at once, gravity pulls it down between the points that it stands on, and
/// friction holds it. A ball does not tilt: it rolls on, however slowly.
/// @param normal out of what it stands on
bool is_at_rest(const Colliding& c, const collide::Convex& shape, const Vec3& normal,
                const Vec3& gravity, double mu, const Stillness& still);

}  // namespace tumble::contact::detail

#ifndef TUMBLE_COMPILED
#include "tumble/contact/rest.inl"
#endif
