#pragma once
/// @file
/// Finding a small oriented box around points.
///
/// The principal axes of the vertices give a first box; turning it about its own edges by ever
/// smaller angles, as long as that makes it smaller, ends in the nearest valley. So the search
/// begins at many turns, on extreme points only, and the best are refined on all points. The axes
/// of the surface, each triangle counted with its area, are no better a start and need triangles.
/// Source: Dimitrov et al., "Bounds on the quality of the PCA bounding boxes", Computational
/// Geometry 42, 2009, on why the first box alone can be poor; the descent is coordinate search.

#include <numbers>

#include "tumble/mass/oriented_box.hpp"

namespace tumble::boxes {

/// @addtogroup mass
/// @{

/// The box along the principal axes of the points: fast, good where the points spread evenly.
/// @throws std::invalid_argument as box_around()
OrientedBox principal_box(std::span<const Vec3> points);

/// @}

}  // namespace tumble::boxes

namespace tumble::detail {

/// The box turned by one of the six steps ±angle about its edges that makes it smallest; itself if
/// none makes it smaller by a millionth.
boxes::OrientedBox turned_smaller(std::span<const Vec3> points, const boxes::OrientedBox& box,
                                  double angle);

}  // namespace tumble::detail

namespace tumble::boxes {

/// @addtogroup mass
/// @{

/// A box that no small turn makes smaller, from a given one.
/// @param points at least one [m]
inline OrientedBox refined_box(std::span<const Vec3> points, OrientedBox box) {
  constexpr double finest = 1e-3;
  double angle = std::numbers::pi / 8;
  while (angle > finest) {
    const OrientedBox turned = detail::turned_smaller(points, box, angle);
    if (turned.volume() < box.volume()) {
      box = turned;
    } else {
      angle /= 2;
    }
  }
  return box;
}

/// A small box around points: the smallest of those found from the principal axes, the coordinate
/// axes, and turns spread over all there are.
/// @throws std::invalid_argument as box_around()
OrientedBox small_oriented_box(std::span<const Vec3> points);

/// @}

}  // namespace tumble::boxes

#ifndef TUMBLE_COMPILED
#include "tumble/mass/bounding_box.inl"
#endif
