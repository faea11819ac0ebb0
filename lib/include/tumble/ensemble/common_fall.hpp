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

#include "tumble/core/types.hpp"

namespace tumble::detail::ensembles {

/// The largest component's size; infinite if one is not finite.
inline double largest_or_infinite(const Vec3& v) {
  return v.allFinite() ? v.cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity();
}

/// How long all have fallen since their x and v were written, and what they have gained by it.
struct CommonFall {
  double time = 0;               ///< T [s]
  Vec3 velocity = Vec3::Zero();  ///< u [m/s]
  Vec3 path = Vec3::Zero();      ///< s [m]

  /// Goes on for a time [s] under an acceleration [m/s²].
  void go_on(double more, const Vec3& acceleration) {
    path += more * velocity + more * more / 2 * acceleration;
    velocity += more * acceleration;
    time += more;
  }
  bool is_none() const { return time == 0 && velocity.isZero(0) && path.isZero(0); }
  Vec3 position(const Vec3& x, const Vec3& v) const { return x + time * v + path; }
  /// Whether no x and v up to these sizes leave the finite numbers by it.
  bool stays_finite(double x, double v) const {
    return std::isfinite(x + std::abs(time) * v + largest_or_infinite(path)) &&
           std::isfinite(v + largest_or_infinite(velocity));
  }
};

}  // namespace tumble::detail::ensembles
