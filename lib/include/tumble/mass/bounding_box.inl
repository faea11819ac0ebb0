#pragma once

#include "tumble/mass/bounding_box.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mass/extreme_points.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::boxes {

TUMBLE_BODY OrientedBox principal_box(std::span<const Vec3> points) {
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

}  // namespace tumble::boxes

namespace tumble::detail {

TUMBLE_BODY boxes::OrientedBox turned_smaller(std::span<const Vec3> points,
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

TUMBLE_BODY OrientedBox small_oriented_box(std::span<const Vec3> points) {
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

}  // namespace tumble::boxes
