#pragma once

#include "tumble/collide/hull_points.hpp"

#include "tumble/collide/distance.hpp"
#include "tumble/core/compiled.hpp"
#include "tumble/mass/extreme_points.hpp"

namespace tumble::collide {

TUMBLE_BODY std::vector<Vec3> hull_points(std::span<const Vec3> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    require(points[i].allFinite(), "hull_points: point ", i, " is not finite");
  std::vector<Vec3> kept = tumble::detail::extreme_points(points);
  const Convex inner = Convex::hull(kept);
  if (kept.size() == points.size()) return kept;
  const Convex centre = Convex::ball(inner.reach());  // only its centre counts in a search
  for (const Vec3& point : points) {
    const detail::Difference difference(inner, {}, centre, {point, Mat3::Identity()});
    detail::Search search(difference);
    search.run();
    if (search.apart()) kept.push_back(point);
  }
  return kept;
}

}  // namespace tumble::collide
