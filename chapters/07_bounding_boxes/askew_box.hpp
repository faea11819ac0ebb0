#pragma once
/// @file
/// The box along the world's axes of an object that lies askew, and how far a tensor is wrong.

#include <numbers>
#include <vector>

#include "tumble/mass/oriented_box.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace bounding_boxes_chapter {

using namespace tumble;
using Points = std::vector<Vec3>;

constexpr double pi = std::numbers::pi, degree = pi / 180;

inline Points turned(Points points, const Mat3& R) {
  for (Vec3& p : points) p = R * p;
  return points;
}

/// The box along the world's axes of an object that is turned by R, seen from the object.
inline boxes::OrientedBox askew_box(const Points& points, const Mat3& R) {
  const boxes::OrientedBox box = boxes::aligned_box(turned(points, R));
  return {R.transpose() * box.centre, R.transpose(), box.size};
}

/// The largest change of a moment about any axis, when each tensor is divided by its own largest
/// moment: a free flight knows of no other difference.
inline double shape_difference(const Mat3& A, const Mat3& B) {
  const auto shape = [](const Mat3& I) -> Mat3 { return I / principal_axes(I).moments[2]; };
  return principal_axes(shape(A) - shape(B)).moments.cwiseAbs().maxCoeff();
}

}  // namespace bounding_boxes_chapter
