#pragma once
/// @file
/// The end of a turning that drag alone acts on. A series follows it at the drag's pace for ever,
/// but once ω is small beside k/J, a body hardly turns until it is at rest: J ω × ω is lost in the
/// rounding of k ω, each component decays by itself, and q turns by what all of them add up to:
///
///     ωᵢ = ωᵢ₀ e^(−z),   θᵢ = ωᵢ₀ t φ₁(−z),   z = kᵢ t,   kᵢ = k/Jᵢ

#include <algorithm>
#include <cmath>
#include <limits>

#include "tumble/steady/steady_path.hpp"
#include "tumble/steady/steady_torque.hpp"

namespace tumble::detail {

/// Less than a rounding [rad].
inline constexpr double lost_turn = 0x1p-60;

/// Whether drag alone acts, and the body turns by less than a rounding before it is at rest.
inline bool only_slows(const steady::SteadyTorque& torque, const steady::TurningState& s) {
  return torque.rank() == 0 &&
         s.omega.cwiseAbs().maxCoeff() <= lost_turn * torque.drag().minCoeff();
}

/// After how long that is so at the latest [s]: |J ω| falls as e^(−z) of the slowest axis or
/// faster.
inline double time_to_slow(const steady::SteadyTorque& torque, const steady::TurningState& s) {
  const double slowest = torque.drag().minCoeff(), fastest = torque.drag().maxCoeff();
  if (torque.rank() > 0 || !(slowest > 0)) return std::numeric_limits<double>::infinity();
  const double ratio = s.omega.norm() / slowest * (fastest / slowest) / lost_turn;
  return std::log(std::max(1.0, ratio)) / slowest;
}

/// What becomes of such a turning.
inline steady::TurningState slowed(const steady::SteadyTorque& torque,
                                   const steady::TurningState& s, double seconds) {
  steady::TurningState then = s;
  Vec3 turned;
  for (int i = 0; i < 3; ++i) {
    const double y = -torque.drag()[i] * seconds;
    turned[i] = s.omega[i] * seconds * phi1(y);
    then.omega[i] *= std::exp(y);
  }
  then.q = s.q * Quat(1, turned[0] / 2, turned[1] / 2, turned[2] / 2);
  return then;
}

}  // namespace tumble::detail
