#pragma once
/// @file
/// Where two bodies that touch do so: at one point, along an edge, or over a face, whose corners
/// are given.

#include "tumble/collide/distance.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// The points of contact of two bodies, from the centre of the first one, in world axes [m].
using ContactPoints = std::vector<Vec3>;

/// @}

}  // namespace tumble::collide

namespace tumble::collide::detail {

using Flat = Eigen::Vector2d;

inline double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Half of the hull of sorted points, from the first one to the last one.
std::vector<Flat> lower_hull(const std::vector<Flat>& points, double width);

/// The corners of the hull of points in a plane, counter-clockwise. What is narrower than `width`
/// is a segment or a point.
std::vector<Flat> flat_hull(std::vector<Flat> points, double width);

/// What a polygon or a segment keeps on the left of the line from a to b, or `width` beside it.
/// Source: Sutherland & Hodgman, "Reentrant polygon clipping", CACM 17(1) (1974).
std::vector<Flat> left_of(const std::vector<Flat>& polygon, const Flat& a, const Flat& b,
                          double width);

/// What two hulls in a plane share; nothing if rounding does not let it be told.
std::vector<Flat> common_part(std::vector<Flat> p, std::vector<Flat> q, double width);

}  // namespace tumble::collide::detail

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// Where a body touches a floor or a wall: its points that are no farther than `tolerance` from the
/// nearest one.
ContactPoints contact_points(const Convex& body, const Pose& pose, const Distance& found,
                             double tolerance);

/// Where two bodies touch: the corners of what their faces share, or the nearest points.
/// @param found     their distance, a's first
/// @param tolerance how far from its plane a point may be [m]
ContactPoints contact_points(const Convex& a, const Pose& pose_a, const Convex& b,
                             const Pose& pose_b, const Distance& found, double tolerance);

/// @}

}  // namespace tumble::collide

#ifndef TUMBLE_COMPILED
#include "tumble/collide/contact_points.inl"
#endif
