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

#include "tumble/mass/extreme_points.hpp"
#include "tumble/mass/oriented_box.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::boxes {

/// @addtogroup mass
/// @{

/// The box along the principal axes of the points: fast, good where the points spread evenly.
/// @throws std::invalid_argument as box_around()
inline OrientedBox principal_box(std::span<const Vec3> points) {
  const Vec3 middle = aligned_box(points).centre;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const Vec3& x : points) {
    const Vec3 r = x - middle;
    first += r;
    second += r * r.transpose();
  }
  const Mat3 spread = second - first * first.transpose() / static_cast<double>(points.size());
  return box_around(points, principal_axes(spread).R);
}

/// @}

}  // namespace tumble::boxes

namespace tumble::detail {

/// The box turned by one of the six steps ±angle about its edges that makes it smallest; itself if
/// none makes it smaller by a millionth.
inline boxes::OrientedBox turned_smaller(std::span<const Vec3> points,
                                         const boxes::OrientedBox& box, double angle) {
  boxes::OrientedBox best = box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double step : {angle, -angle}) {
      const Mat3 R = box.R * Eigen::AngleAxisd(step, Vec3::Unit(axis)).toRotationMatrix();
      const boxes::OrientedBox turned = boxes::box_around(points, R);
      if (turned.volume() < best.volume() * (1 - 1e-6)) best = turned;
    }
  }
  return best;
}

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
inline OrientedBox small_oriented_box(std::span<const Vec3> points) {
  constexpr int starts = 24;
  OrientedBox best = aligned_box(points);
  const std::vector<Vec3> extreme = detail::extreme_points(points);
  const auto consider = [&](const Mat3& R) {
    const OrientedBox found = refined_box(extreme, box_around(extreme, R));
    const OrientedBox whole = box_around(points, found.R);
    if (whole.volume() < best.volume()) best = whole;
  };
  consider(principal_box(points).R);
  consider(Mat3::Identity());
  for (const Vec3& axis : detail::half_sphere(starts)) {
    const Vec3 across = axis.unitOrthogonal();
    Mat3 R;
    R << across, axis.cross(across), axis;
    consider(R);
  }
  return refined_box(points, best);
}

/// @}

}  // namespace tumble::boxes
