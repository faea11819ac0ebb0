#pragma once
/// @file
/// Boxes along the axes of the world that a body does not leave: while it stands, or over a flight.

#include "tumble/core/types.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// All points with min() ≤ (x, y, z) ≤ max(), borders included [m].
using Bounds = Eigen::AlignedBox3d;

/// A centre that flies under a constant acceleration: x + v s + a s²/2 at the time s.
struct Parabola {
  Vec3 x = Vec3::Zero();  ///< at s = 0 [m]
  Vec3 v = Vec3::Zero();  ///< at s = 0 [m/s]
  Vec3 a = Vec3::Zero();  ///< [m/s²]

  Vec3 at(double s) const { return x + s * (v + s / 2 * a); }
};

/// The bounds of a ball around a centre [m].
inline Bounds ball_bounds(const Vec3& centre, double radius) {
  return {centre - Vec3::Constant(radius), centre + Vec3::Constant(radius)};
}

/// The bounds of all places that a ball passes on its flight from s = 0 on. A body that turns about
/// its centre stays in the ball around the centre which holds it.
/// @param duration of the flight [s], ≥ 0
/// @param radius   of the ball [m], ≥ 0
/// @return wider than the true bounds by some roundings, never narrower
/// @throws std::invalid_argument if a number is not finite, or duration or radius is negative
Bounds swept_bounds(const Parabola& flight, double duration, double radius);

/// @}

}  // namespace tumble::collide

#ifndef TUMBLE_COMPILED
#include "tumble/collide/bounds.inl"
#endif
