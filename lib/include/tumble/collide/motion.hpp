#pragma once
/// @file
/// How a body moves over a time, with bounds that hold all the while, and what they say about how
/// far it reaches along a direction.

#include <concepts>

#include "tumble/body/derived.hpp"
#include "tumble/collide/convex.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// A rigid motion with a centre under constant acceleration, and with bounds on its turning.
template <class M>
concept Motion = requires(const M& motion, double t) {
  { motion.at(t) } -> std::convertible_to<Derived<>>;
  { motion.acceleration() } -> std::convertible_to<Vec3>;                 // of the centre [m/s²]
  { motion.most_spin() } -> std::convertible_to<double>;                  // bound on |ω| [rad/s]
  { motion.most_angular_acceleration() } -> std::convertible_to<double>;  // |dω/dt| [rad/s²]
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
Reach farthest_reach(const Convex& body, const Derived<>& now, const Vec3& n, double s);

/// The gap along n between the points of two bodies that are nearest at the time s from now.
inline Reach gap_between(const Convex& a, const Derived<>& now_a, const Convex& b,
                         const Derived<>& now_b, const Vec3& n, double s) {
  const Reach reach_a = farthest_reach(a, now_a, n, s), reach_b = farthest_reach(b, now_b, -n, s);
  return {n.dot(now_b.x - now_a.x) - reach_a.value - reach_b.value, -reach_a.rate - reach_b.rate};
}

/// Bound on how fast a point of the hull is accelerated along n because the body turns [m/s²].
///
/// With r the point's arm and ω = a n + w, w across n, the acceleration along n is
///   n·(ω × (ω × r)) + n·(ω̇ × r) = a w·r − w² n·r + n·(ω̇ × r),
/// as ω × (ω × r) = (ω·r) ω − ω² r. The vector a w − w² n has length w √(a² + w²) = w |ω|, so the
/// sum is at most (w |ω| + |ω̇|) |r|. A turn about n moves no point along it: w alone counts, and
/// grows from its size now by |ω̇| at most.
/// @param within a time from now [s]
template <Motion M>
double turning_along(const Moving<M>& moving, const Derived<>& now, const Vec3& n, double within) {
  const double spin = moving.motion.most_spin(), faster = moving.motion.most_angular_acceleration();
  constexpr double rounding = 16 * tumble::detail::unit_roundoff;  // of ω
  const double across =
      std::fmin(spin, n.cross(now.omega).norm() + faster * within + rounding * spin);
  return (moving.body.reach() - moving.body.radius()) * (across * spin + faster);
}

}  // namespace tumble::collide::detail

#ifndef TUMBLE_COMPILED
#include "tumble/collide/motion.inl"
#endif
