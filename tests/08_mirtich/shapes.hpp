#pragma once
/// @file
/// Polygons that the specs of this chapter try.

#include <cmath>
#include <numbers>
#include <vector>

#include "judge/spec/inputs.hpp"

namespace tumble::judge {

using Corners = std::vector<Vec3>;

/// A polygon of n corners in the xy plane around the origin, counter-clockwise; it may have dents,
/// and does not cross itself. Its corners are `size` away from the origin at most.
inline Corners any_star(int n, double size = 1) {
  Corners corners;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * (k + any_number(-0.3, 0.3)) / n;
    const double r = size * any_number(0.3, 1);
    corners.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return corners;
}

/// Every corner x at A x + d.
inline Corners mapped(Corners corners, const Mat3& A, const Vec3& d) {
  for (Vec3& x : corners) x = A * x + d;
  return corners;
}

inline Corners reversed(const Corners& corners) { return {corners.rbegin(), corners.rend()}; }

/// The largest coordinate of all corners in size.
inline double farthest(const Corners& corners) {
  double largest = 0;
  for (const Vec3& x : corners) largest = std::fmax(largest, x.lpNorm<Eigen::Infinity>());
  return largest;
}

}  // namespace tumble::judge
