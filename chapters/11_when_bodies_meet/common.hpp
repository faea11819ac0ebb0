#pragma once
/// @file
/// What all parts of this chapter's program share: how numbers are written, and impacts in a plane.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/plot.hpp"
#include "support/random.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/body.hpp"
#include "tumble/contact.hpp"

namespace contact_chapter {

using namespace tumble;
using support::degrees, support::error_number, support::error_or_rounding, support::number;
using support::Pen, support::Plot, support::Series, support::Sketch, support::Table, support::Vec2;
using Mat2 = Eigen::Matrix2d;

constexpr double pi = std::numbers::pi, degree = pi / 180, gravity = 9.81;

// ── Numbers ──

/// Rounded, so that the last digits of another compiler make no other text, and never −0.
inline std::string rounded(double x, int digits = 3) {
  const double scale = std::pow(10, digits), near = std::round(scale * x) / scale;
  return number(near == 0 ? 0 : near, 6);
}

/// A share in percent, with its sign.
inline std::string percent(double share) {
  const std::string text = rounded(100 * share, 1);
  return (text == "0" || share < 0 ? "" : "+") + text + " %";
}

inline std::string yes_or_no(bool yes) { return yes ? "yes" : "no"; }

// ── Impacts in a plane: along the surface, and along the normal ──

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
