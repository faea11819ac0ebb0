#pragma once
/// @file
/// Points and boxes to try the units of chapter 7 on.

#include <algorithm>
#include <cmath>
#include <vector>

#include "07_bounding_boxes/contract.hpp"
#include "judge/spec/inputs.hpp"
#include "tumble/core/types.hpp"
#include "tumble/mass/oriented_box.hpp"

namespace tumble::judge {

using bounding_boxes::Box;
using Points = std::vector<Vec3>;

inline Box to_box(const boxes::OrientedBox& box) { return {box.centre, box.R, box.size}; }

/// Points in a cube, about a place.
inline Points any_points(int n, double size = 2, const Vec3& place = Vec3::Zero()) {
  Points points;
  for (int i = 0; i < n; ++i) points.push_back(place + any_vector(size));
  return points;
}

/// The points moved: x → A x + shift.
inline Points mapped(Points points, const Mat3& A, const Vec3& shift = Vec3::Zero()) {
  for (Vec3& point : points) point = A * point + shift;
  return points;
}

/// How far the farthest point is from the origin along an axis, at most [m].
inline double reach(const Points& points) {
  double farthest = 0;
  for (const Vec3& point : points) farthest = std::fmax(farthest, point.lpNorm<Eigen::Infinity>());
  return farthest;
}

inline Vec3 mean(const Points& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point - points.front();
  return points.front() + sum / static_cast<double>(points.size());
}

/// How far the farthest point sticks out of the box, if any does [m].
inline double sticks_out(const Box& box, const Points& points) {
  double worst = 0;
  for (const Vec3& point : points) {
    const Vec3 r = box.R.transpose() * (point - box.centre);
    worst = worse(worst, (r.cwiseAbs() - box.size / 2).maxCoeff<Eigen::PropagateNaN>());
  }
  return worst;
}

/// How far the box could still shrink at its loosest face [m].
inline double loose_by(const Box& box, const Points& points) {
  Vec3 low = Vec3::Constant(INFINITY), high = -low;
  for (const Vec3& point : points) {
    const Vec3 r = box.R.transpose() * (point - box.centre);
    low = low.cwiseMin(r);
    high = high.cwiseMax(r);
  }
  return worse((box.size / 2 - high).maxCoeff<Eigen::PropagateNaN>(),
               (low + box.size / 2).maxCoeff<Eigen::PropagateNaN>());
}

}  // namespace tumble::judge
