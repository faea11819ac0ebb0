#pragma once
/// @file
/// Boxes along the axes of the world that a body does not leave: while it stands, or over a flight.

#include <cmath>
#include <limits>

#include "tumble/core/require.hpp"
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
inline Bounds swept_bounds(const Parabola& flight, double duration, double radius) {
  require(flight.x.allFinite() && flight.v.allFinite() && flight.a.allFinite(),
          "swept_bounds: the flight is not finite");
  require(duration >= 0 && std::isfinite(duration), "swept_bounds: the duration ", duration,
          " s is not finite and ≥ 0");
  require(radius >= 0 && std::isfinite(radius), "swept_bounds: the radius ", radius,
          " m is not finite and ≥ 0");
  Bounds swept(flight.x);
  swept.extend(flight.at(duration));
  for (int i = 0; i < 3; ++i) {
    const double turn = -flight.v[i] / flight.a[i];  // where this coordinate turns round
    if (turn > 0 && turn < duration) swept.extend(flight.at(turn));
  }
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  const Vec3 sizes =
      flight.x.cwiseAbs() + duration * (flight.v.cwiseAbs() + duration / 2 * flight.a.cwiseAbs());
  const Vec3 wider = rounding * sizes + Vec3::Constant((1 + rounding) * radius);
  return {swept.min() - wider, swept.max() + wider};
}

/// @}

}  // namespace tumble::collide
