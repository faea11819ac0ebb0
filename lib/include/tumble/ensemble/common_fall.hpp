#pragma once
/// @file
/// What the paths of all bodies have in common while nothing acts but one weight for all:
///
///   x(T) = x + T v + s(T),   v(T) = v + u(T)
///
/// with the same s and u for each. So a step writes these, and no body's x and v: where bodies are
/// many, a step takes as long as memory does.

#include <cmath>
#include <limits>
#include <span>

#include "tumble/core/types.hpp"
#include "tumble/ensemble/eights.hpp"

namespace tumble::detail::ensembles {

/// How large the components of all x [m] and v [m/s] are at most; infinite if one is not finite.
struct Extent {
  double x = 0, v = 0;
};

inline Extent extent_of(std::span<const EightPaths> paths) {
  Extent extent;
  double not_finite = 0;  // NaN if a number is not
  for (const EightPaths& path : paths)
    for (int k = 0; k < 3; ++k)
      for (int lane = 0; lane < eight; ++lane) {
        const double x = path.x[k][lane], v = path.v[k][lane];
        extent.x = std::max(extent.x, std::abs(x));
        extent.v = std::max(extent.v, std::abs(v));
        not_finite += 0 * x + 0 * v;
      }
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return not_finite == 0 ? extent : Extent{infinite, infinite};
}

/// How long all have fallen since their x and v were written, and what they have gained by it.
struct CommonFall {
  double time = 0;               ///< T [s]
  Vec3 velocity = Vec3::Zero();  ///< u [m/s]
  Vec3 path = Vec3::Zero();      ///< s [m]

  /// Goes on for a time [s] under an acceleration [m/s²].
  void go_on(double more, const Vec3& acceleration) {
    path += more * (velocity + more / 2 * acceleration);
    velocity += more * acceleration;
    time += more;
  }
  bool is_none() const { return time == 0 && velocity.isZero(0) && path.isZero(0); }
  double position(double x, double v, int axis) const { return x + time * v + path[axis]; }

  /// Writes where eight bodies are by now, and how fast.
  void write_to(EightPaths& to) const {
    for (int k = 0; k < 3; ++k)
      for (int lane = 0; lane < eight; ++lane) {
        to.x[k][lane] = position(to.x[k][lane], to.v[k][lane], k);
        to.v[k][lane] += velocity[k];
      }
  }
  /// Whether no x and v of this extent leave the finite numbers by it.
  bool stays_finite(const Extent& from) const {
    const double x = path.cwiseAbs().sum(), v = velocity.cwiseAbs().sum();
    return std::isfinite(from.x + std::abs(time) * from.v + x) && std::isfinite(from.v + v);
  }
};

}  // namespace tumble::detail::ensembles
