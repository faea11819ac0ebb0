#pragma once
/// @file
/// Chapter 7, bounding boxes: what you write, one function per file.
///
/// A box around a body can stand in for it, because its inertia is a short formula. The page says
/// what that costs in accuracy; here you make the boxes. "To rounding of the places" means: as if
/// each coordinate were off by some roundings of the largest one.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises, such as
/// those of chapter 6. The judge supplies correct ones, even where yours don't pass yet. Other
/// parts of Eigen are not there, so no eigenvectors: `principal_axes`, below, computes the axes
/// that you need.

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "../06_point_sampling/contract.hpp"
#include "not_implemented.hpp"

namespace bounding_boxes {

/// A solid box anywhere in the world.
struct Box {
  Eigen::Vector3d centre;  ///< its middle [m]
  Eigen::Matrix3d R;       ///< orientation, box → world: its columns are the edges' directions
  Eigen::Vector3d size;    ///< full lengths of the edges along these columns [m], 0 or more
};

/// The axes of a symmetric matrix S, ready for use: a rotation R whose columns are three directions
/// that S only stretches, so that Rᵀ S R is diagonal. Jacobi's method: one number off the diagonal
/// after the other is turned to zero.
/// @param S symmetric; if it stretches by equal amounts along two of the axes, you get any two
///          perpendicular directions of their plane
inline Eigen::Matrix3d principal_axes(Eigen::Matrix3d S) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  for (int round = 0; round < 24; ++round) {
    const int i = round % 3, j = (i + 1) % 3;
    if (S(i, j) == 0) continue;
    // The turn in the plane of i and j, by 45° at most, that makes S(i, j) zero.
    const double cot = (S(j, j) - S(i, i)) / (2 * S(i, j));
    const double tan = std::copysign(1 / (std::abs(cot) + std::hypot(cot, 1)), cot);
    const double cos = 1 / std::hypot(tan, 1), sin = tan * cos;
    const auto turn = [cos, sin](double& x, double& y) {
      const double before = x;
      x = cos * before - sin * y;
      y = sin * before + cos * y;
    };
    for (int k = 0; k < 3; ++k) turn(S(i, k), S(j, k));  // its rows
    for (int k = 0; k < 3; ++k) turn(S(k, i), S(k, j));  // its columns
    S(i, j) = S(j, i) = 0;
    for (int k = 0; k < 3; ++k) turn(R(k, i), R(k, j));
  }
  return R;
}

// == 7.1 bounding_box: the box along the axes
/// @param points one or more, anywhere [m]
/// @return the smallest box with its edges along x, y and z that holds all points: R is the
///         identity. To rounding of the places; edges may come out as zero.
Box bounding_box(const std::vector<Eigen::Vector3d>& points);

// == 7.2 box_inertia: what a box in the place of the body would have
/// The mass fills the box evenly. As a rule it is the true mass of a body, spread over a box around
/// it.
/// @param mass  of the box [kg], 0 or more
/// @param box   anywhere, turned in any way; an edge may be zero, as of a plate or of a rod
/// @param about the point about which you want the inertia [m]; only sometimes the box's centre
/// @return the inertia tensor in world axes [kg m²], products with the minus sign, to rounding.
///         Box and `about` may lie together 1e8 m away from the origin: you must lose no digit by
///         that.
Eigen::Matrix3d box_inertia(double mass, const Box& box, const Eigen::Vector3d& about);

// == 7.3 fit_oriented_box: a box that lies along the body
/// The points scatter about their mean c by the matrix Σ (p − c)(p − c)ᵀ, in which all count alike.
/// Take its principal axes as the directions of the box's edges. Of all boxes with these directions
/// give the smallest that holds all points.
/// @param points one or more, anywhere [m]. They scatter by clearly different amounts along the
///               three axes, unless they are all on a line or in one place.
/// @return the box: R is a rotation. Its columns, each with its number in `size`, may come in any
///         order and with either sign. To rounding of the places: errors may grow with the number
///         of points, and with their distance from the origin, but not with its square.
Box fit_oriented_box(const std::vector<Eigen::Vector3d>& points);

}  // namespace bounding_boxes
