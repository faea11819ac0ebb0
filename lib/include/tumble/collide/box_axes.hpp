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
std::optional<Gap> largest_gap(const Difference& difference);

}  // namespace tumble::collide::detail

#ifndef TUMBLE_COMPILED
#include "tumble/collide/box_axes.inl"
#endif
