#pragma once

#include "tumble/collide/bounds.hpp"

#include <cmath>
#include <limits>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::collide {

TUMBLE_BODY Bounds swept_bounds(const Parabola& flight, double duration, double radius) {
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

}  // namespace tumble::collide
