#pragma once
/// @file
/// When bounces become so low that a body stays in touch, and whether it then is at rest.
///
/// A ball that bounces with e < 1 does so infinitely often in a finite time: each flight lasts e
/// times as long as the one before. Other bodies rock from corner to corner, and do the same.

#include <cmath>

#include "tumble/collide/contact_points.hpp"
#include "tumble/contact/several_points.hpp"

namespace tumble::contact::detail {

/// A contact right after its impulses.
struct Aftermath {
  double coming;     ///< the speed at which the fastest of its points came [m/s]
  double parting;    ///< the least speed at which one leaves [m/s]
  double first;      ///< the largest speed at which this body has landed since it last stood [m/s]
  double pull;       ///< acceleration that brings it back [m/s²], 0 if that is not known
  double e;          ///< coefficient of restitution
  double tolerance;  ///< [m]
};

/// Whether the bodies stay in touch: they part with a billionth of the speed at which they came
/// first, or, where contacts are known to the tolerance only, do not rise above the tolerance.
inline bool stays(const Aftermath& after, bool is_ball) {
  const double little = 1e-9 * after.first;
  // So slow that it does not rise, or has not fallen, by more than the tolerance.
  const double lowest = std::sqrt(2 * std::fmax(0, after.pull) * after.tolerance);
  if (after.first <= lowest) return true;  // it stood there
  if (after.parting <= little && after.coming <= little) return true;
  if (after.e == 1 || !(after.pull > 0)) return false;
  return after.parting <= (is_ball ? little : std::fmax(little, lowest));
}

/// The time that all bounces still take [s]: the sum of 2 u/g e^k.
inline double time_to_rest(const Aftermath& after) {
  return after.e < 1 ? 2 * std::fmax(0, after.parting) / (after.pull * (1 - after.e)) : 0;
}

/// Whether a body that stays in touch is at rest there: it has no energy to tilt or to go on,
/// gravity pulls it down between the points that it stands on, and friction holds it.
/// @param normal out of what it stands on
inline bool is_at_rest(const Colliding& c, const collide::Convex& shape, const Vec3& normal,
                       const Vec3& gravity, double mu) {
  constexpr double little = 1e-6;  // of its reach: so far could its energy lift it
  constexpr double near = 1e-4;    // of its reach: so close are the points that it stands on
  const double pull = -normal.dot(gravity), sideways = (gravity + pull * normal).norm();
  if (!(pull > 0) || sideways > (mu + 1e-12) * pull) return false;
  if (kinetic_energy(c.body, c.state) > little * c.body.mass() * pull * shape.reach()) return false;
  const collide::Pose pose{Vec3::Zero(), to_matrix(c.state.q)};
  const auto below = distance(shape, pose, collide::HalfSpace{Vec3::Zero(), normal});
  const auto points = contact_points(shape, pose, below, near * shape.reach());
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  // Where the line of gravity through the centre meets the ground.
  const Vec3 foot = gravity * (normal.dot(below.arm_a) / normal.dot(gravity));
  std::vector<Eigen::Vector2d> feet;
  for (const Vec3& p : points) feet.emplace_back(x.dot(p - foot), y.dot(p - foot));
  const auto hull = collide::detail::flat_hull(std::move(feet), 1e-9 * shape.reach());
  if (hull.size() == 1) return hull[0].norm() < 1e-9 * shape.reach();
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (collide::detail::turn(hull[i], hull[(i + 1) % hull.size()], {0, 0}) < 0) return false;
  return hull.size() > 2;
}

}  // namespace tumble::contact::detail
