#pragma once
/// @file
/// How far apart two convex bodies are, or how deep they overlap, with a certificate: a direction
/// along which all of one lies behind all of the other.
///
/// Source: Gilbert, Johnson & Keerthi, "A fast procedure for computing the distance between complex
/// objects in three-dimensional space", IEEE J. Robotics and Automation 4(2) (1988). It ends when
/// its two bounds on the distance meet to rounding: one from two points, one from two planes.

#include "tumble/collide/box_axes.hpp"
#include "tumble/collide/nearest_in_simplex.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// Two parallel planes between two bodies, or the least shift that frees them.
struct Distance {
  /// From a's plane to b's [m]; negative where they overlap. That no body reaches beyond its plane
  /// has been checked on all points of both.
  double gap;
  Vec3 normal;  ///< of the planes, unit, from a to b
  Vec3 arm_a;   ///< the point of a that is nearest to b, from the centre of a, in world axes [m]
  Vec3 arm_b;   ///< the point of b that is nearest to a, from the centre of b, in world axes [m]
  /// The true distance is gap … gap + uncertainty [m], but for rounding of the places.
  double uncertainty;
  int rounds;  ///< how many farthest points it took
};

/// @}

}  // namespace tumble::collide

namespace tumble::collide::detail {

/// The search for the point of a difference that is nearest to the origin.
class Search {
 public:
  explicit Search(const Difference& difference)
      : difference_(difference), rounding_(rounding_of(difference)) {
    const Vec3& offset = difference.offset();
    nearest_.add(difference.nearest_along(offset.isZero(0) ? Vec3(Vec3::UnitX()) : offset), 1);
    upper_ = nearest_.point().norm();
  }

  void run() {
    constexpr int max_rounds = 1000;
    while (upper_ > rounding_ && rounds_ < max_rounds)
      if (!improve()) break;
    if (upper_ - lower_ > rounding_)
      if (const auto gap = largest_gap(difference_); gap && gap->size > lower_) {
        lower_ = gap->size;
        normal_ = gap->normal;
      }
  }

  const Simplex& nearest() const { return nearest_; }
  double gap() const { return lower_; }
  const Vec3& normal() const { return normal_; }
  double uncertainty() const { return std::max(0., upper_ - lower_); }
  int rounds() const { return rounds_; }
  /// Whether a plane with nothing of either body on its other side has been found.
  bool apart() const { return upper_ > rounding_ && lower_ > 0; }

 private:
  /// Looks for a corner beyond the plane through the nearest point, and for a nearer point with it.
  bool improve() {
    ++rounds_;
    const Corner next = corner_along(direction_to(nearest_, nearest_.point()));
    if (upper_ - lower_ <= rounding_) return false;
    Simplex wider = nearest_;
    if (!wider.has(next)) wider.add(next);
    const Simplex better = nearest_in(wider, rounding_);
    const double distance = better.point().norm();
    if (!(distance < upper_)) return turn_normal(wider);
    nearest_ = better;
    upper_ = distance;
    return true;
  }

  /// The corner nearest to the origin along n, and the gap that this certifies.
  Corner corner_along(const Vec3& n) {
    Corner corner = difference_.nearest_along(n);
    if (const double gap = n.dot(corner.w); gap > lower_) {
      lower_ = gap;
      normal_ = n;
    }
    return corner;
  }

  /// The nearest point is known to rounding, but its direction is not: it is short, and rounding
  /// turns it. The faces through its corners tell the direction better.
  /// @return whether a corner was found that leads on
  bool turn_normal(const Simplex& corners) {
    for (int mask = 1; mask < 1 << corners.size; ++mask) {
      const Simplex face = part_of(corners, mask);
      if (face.size == 4) continue;
      ++rounds_;
      const Corner next = corner_along(direction_to(face, nearest_.point()));
      if (upper_ - lower_ <= rounding_) return false;
      Simplex wider = nearest_;
      if (wider.size == 4 || wider.has(next)) continue;
      wider.add(next);
      const Simplex better = nearest_in(wider, rounding_);
      if (better.point().norm() >= upper_) continue;
      nearest_ = better;
      upper_ = better.point().norm();
      return true;
    }
    return false;
  }

  const Difference& difference_;
  double rounding_;
  Simplex nearest_;
  double upper_ = 0, lower_ = -std::numeric_limits<double>::infinity();
  Vec3 normal_ = Vec3::UnitX();
  int rounds_ = 1;
};

/// The distance of the bodies with their radii: `gap` and `nearest` are those without.
Distance with_radii(const Difference& difference, const Simplex& nearest, double gap,
                    const Vec3& normal, const Convex& a, const Convex& b);

/// The distance of bodies whose hulls overlap or touch.
Distance overlap(const Difference& difference, const Simplex& inside, const Convex& a,
                 const Convex& b);

}  // namespace tumble::collide::detail

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// The distance of two bodies, to rounding of their places relative to each other.
Distance distance(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b);

/// The distance of a body from a floor or a wall, to rounding. The nearest point of the half space
/// is given from the half space's own point.
Distance distance(const Convex& body, const Pose& pose, const HalfSpace& wall);

/// @}

}  // namespace tumble::collide

#ifndef TUMBLE_COMPILED
#include "tumble/collide/distance.inl"
#endif
