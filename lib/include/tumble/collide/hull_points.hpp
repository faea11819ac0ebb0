#pragma once
/// @file
/// The points that make a hull: what a fine mesh has inside its hull only takes time.

#include <span>
#include <vector>

#include "tumble/core/types.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// Of many points, those that the hull of their extreme points in some hundred directions does not
/// hold, and these extreme points. Their hull is that of all, to rounding; some of them may still
/// lie inside.
/// @throws std::invalid_argument if the hull has no volume, or a point is not finite
std::vector<Vec3> hull_points(std::span<const Vec3> points);

/// @}

}  // namespace tumble::collide

#ifndef TUMBLE_COMPILED
#include "tumble/collide/hull_points.inl"
#endif
