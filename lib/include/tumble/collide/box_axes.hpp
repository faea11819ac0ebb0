#pragma once
/// @file
/// The 15 directions that tell whether two boxes overlap, and how deep: what is left to ask where
/// boxes are so thin that rounding blurs their nearest points.
///
/// Source: Gottschalk, Lin & Manocha, "OBBTree: a hierarchical structure for rapid interference
/// detection", SIGGRAPH 1996, §5.

#include <optional>

#include "tumble/collide/difference.hpp"

namespace tumble::collide::detail {

/// A direction, and the gap between two bodies along it.
struct Gap {
  double size;  ///< [m], negative where they overlap
  Vec3 normal;  ///< from a to b
};

/// The largest gap between two boxes along the 15 directions; nothing if they are no boxes.
inline std::optional<Gap> largest_gap(const Difference& difference) {
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
