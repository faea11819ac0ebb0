#pragma once
/// @file
/// Impacts in a plane: along the surface, and along the normal. And the rod on which the chapter
/// tries its laws.

#include <cmath>
#include <numbers>

#include "tumble/core/types.hpp"

namespace contact_chapter {

using namespace tumble;
using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// A contact in a plane before it hits.
struct PlanarImpact {
  Mat2 K;
  Vec2 u;
  double e, mu;
};

/// What is left of it.
struct PlanarResult {
  Vec2 impulse, u;
};

/// Gained by the impulse [J].
inline double energy_change(const PlanarImpact& impact, const PlanarResult& result) {
  return (impact.u + result.u).dot(result.impulse) / 2;
}

/// The most that an impulse can take away, by bringing the point to rest [J].
inline double energy_at_stake(const PlanarImpact& impact) {
  return impact.u.dot(impact.K.inverse() * impact.u) / 2;
}

inline PlanarResult with_impulse(const PlanarImpact& impact, const Vec2& j) {
  return {j, impact.u + impact.K * j};
}

/// A uniform slender rod of 1 kg and 2 m, the tip of which is on the floor and to the left of the
/// centre: K of the tip.
/// @param angle to the floor [rad]
inline Mat2 tip_of_rod(double angle) {
  constexpr double mass = 1, inertia = 1. / 3;
  const Vec2 arm(-std::cos(angle), -std::sin(angle)), turning(-arm.y(), arm.x());
  return Mat2::Identity() / mass + turning * turning.transpose() / inertia;
}

/// The rod of the hook: at 30°, its tip slides slowly.
inline PlanarImpact hook_rod() { return {tip_of_rod(30 * degree), {0.2, -1}, 0.9, 0.5}; }

}  // namespace contact_chapter
