#pragma once
/// @file
/// Curves in the plane of impulses.

#include <algorithm>
#include <cmath>
#include <vector>

#include "11_when_bodies_meet/planar_impact.hpp"

namespace contact_chapter {

/// A rectangle around points.
struct Extent {
  Vec2 low, high;

  void hold(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Vec2 size() const { return high - low; }
  Vec2 middle() const { return (low + high) / 2; }
};

/// The impulses that leave the energy as it was, u·j + ½ j·K j = 0: a closed curve through 0, in
/// each direction d at −2 u·d / (d·K d).
inline std::vector<Vec2> lossless(const PlanarImpact& impact) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 120; ++i) {
    const double at = pi * i / 120;
    const Vec2 d(std::cos(at), std::sin(at));
    points.emplace_back(-2 * impact.u.dot(d) / d.dot(impact.K * d) * d);
  }
  return points;
}

/// The line a·j + b = 0 as far as it is seen: two points, or none.
inline std::vector<Vec2> line_within(const Vec2& a, double b, const Extent& seen) {
  const Vec2 along(-a.y(), a.x()), start = -b / a.squaredNorm() * a;
  double first = -1e9, last = 1e9;
  for (int i = 0; i < 2; ++i) {
    if (along[i] == 0) continue;
    const double low = (seen.low[i] - start[i]) / along[i],
                 high = (seen.high[i] - start[i]) / along[i];
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  if (!(first < last)) return {};
  return {start + first * along, start + last * along};
}

}  // namespace contact_chapter
