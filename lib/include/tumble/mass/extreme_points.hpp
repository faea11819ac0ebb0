#pragma once
/// @file
/// The points of a cloud that any box around it can touch, or nearly all of them: what a search for
/// boxes has to look at.
///
/// Source: the ε-kernel of Agarwal, Har-Peled & Varadarajan, "Approximating extent measures of
/// points", J. ACM 51 (2004): the extreme points in enough directions.

#include <span>
#include <vector>

#include "tumble/core/types.hpp"

namespace tumble::detail {

/// Directions spread evenly over half a sphere: a spiral whose turns are the golden angle.
std::vector<Vec3> half_sphere(int count);

/// The two points farthest apart along each of many directions, each point once.
std::vector<Vec3> extreme_points(std::span<const Vec3> points);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mass/extreme_points.inl"
#endif
