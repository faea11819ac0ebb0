#pragma once
/// @file
/// How a body moves over a time, with bounds that hold all the while, and what they say about how
/// far it reaches along a direction.

#include <concepts>

#include "tumble/body/derived.hpp"
#include "tumble/collide/convex.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// A rigid motion with a centre under constant acceleration, and with bounds on its turning.
template <class M>
concept Motion = requires(const M& motion, double t) {
  { motion.at(t) } -> std::convertible_to<Derived<>>;
  { motion.acceleration() } -> std::convertible_to<Vec3>;    // of the centre [m/s²]
  { motion.most_spin() } -> std::convertible_to<double>;     // bound on |ω| [rad/s]
  { motion.most_turning() } -> std::convertible_to<double>;  // bound on |ω|² + |dω/dt| [1/s²]
};

/// A body on its way.
template <Motion M>
struct Moving {
  const Convex& body;
  const M& motion;
};

inline Pose pose_of(const Derived<>& now) { return {now.x, now.R}; }

/// @}

}  // namespace tumble::collide

namespace tumble::collide::detail {

/// How far a point of a body reaches along a direction, from the body's centre at a time t0.
struct Reach {
  double value;  ///< at t0 [m]
  double rate;   ///< at t0 [m/s]
};

/// The point that reaches farthest along n at the time s after `now`, if velocities stayed as they
/// are: n·(v s + r + s ω × r) is a dot product with r.
inline Reach farthest_reach(const Convex& body, const Derived<>& now, const Vec3& n, double s) {
  const Vec3 along = now.R.transpose() * (n + s * n.cross(now.omega));
  const Vec3 arm = now.R * body.point(body.farthest(along));
  return {n.dot(arm) + body.radius(), n.dot(now.v + now.omega.cross(arm))};
}

/// Bound on how fast a point of the hull is accelerated because the body turns [m/s²].
template <Motion M>
double turning_of(const Moving<M>& moving) {
  return (moving.body.reach() - moving.body.radius()) * moving.motion.most_turning();
}

}  // namespace tumble::collide::detail
