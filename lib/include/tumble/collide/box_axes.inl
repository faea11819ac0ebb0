#pragma once

#include "tumble/collide/box_axes.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::collide::detail {

TUMBLE_BODY std::optional<Gap> largest_gap(const Difference& difference) {
  const auto edges = difference.box_edges();
  std::optional<Gap> best;
  const auto look = [&](const Vec3& axis) {
    for (const Vec3& n : {axis, Vec3(-axis)}) {
      const double gap = n.dot(difference.nearest_along(n).w);
      if (!best || gap > best->size) best = Gap{gap, n};
    }
  };
  for (const auto& own : edges)
    for (const Vec3& edge : own) look(edge.normalized());
  constexpr double parallel = 1e-12;  // then the product says nothing, and the faces say it all
  for (const Vec3& e : edges[0])
    for (const Vec3& f : edges[1])
      if (e.cross(f).norm() > parallel) look(e.cross(f).normalized());
  return best;
}

}  // namespace tumble::collide::detail
