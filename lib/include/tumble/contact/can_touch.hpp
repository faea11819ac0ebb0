#pragma once
/// @file
/// Whether anything can touch at all. Where nothing can, no search for contacts has to run.

#include <limits>

#include "tumble/contact/scene.hpp"

namespace tumble::contact::detail {

/// Of all numbers that a distance is made of, what rounding may have changed.
inline constexpr double path_rounding = 32 * std::numeric_limits<double>::epsilon();

/// The way of a body's centre, as long as the body touches nothing.
inline collide::Parabola free_path(const ContactBody& b, const Vec3& gravity) {
  return {b.start.x, b.start.P / b.body.mass(), gravity};
}

/// Bound on the coordinates of a path.
inline double size_of(const collide::Parabola& path, double until) {
  return path.x.norm() + until * (path.v.norm() + until / 2 * path.a.norm());
}

/// The least value of h + v s + a s²/2 for 0 ≤ s ≤ until.
double lowest(double h, double v, double a, double until);

/// Whether a ball on its path reaches the wall.
bool reaches(const collide::Parabola& path, double radius, const collide::HalfSpace& wall,
             double until);

/// Whether two balls meet that fall alike: seen from one, the other goes straight on.
bool reaches(const collide::Parabola& a, const collide::Parabola& b, double radii, double until);

/// What a ball passes, as one sees it who falls along: gravity moves all of them alike.
inline collide::Bounds swept_falling_along(const collide::Parabola& path, double until,
                                           double radius) {
  return collide::swept_bounds({path.x, path.v, Vec3::Zero()}, until, radius);
}

/// Whether any two bodies meet. Of many, those are compared whose swept bounds overlap.
bool any_pair_meets(const ContactScene& scene, double until);

}  // namespace tumble::contact::detail

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// Whether any body can touch a wall or another body from t = 0 to `until`: whether the balls
/// around the centres of mass which hold the bodies meet on their flights. It takes some products
/// per body, and a sort.
/// @param until [s], finite and ≥ 0
/// @return false only if nothing touches, to rounding. True does not promise that something does.
/// @throws std::invalid_argument if `until` is none
bool can_touch(const ContactScene& scene, double until);

/// @}

}  // namespace tumble::contact

#ifndef TUMBLE_COMPILED
#include "tumble/contact/can_touch.inl"
#endif
