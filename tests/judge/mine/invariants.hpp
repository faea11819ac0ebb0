#pragma once
/// @file
/// What stays as it is in a motion, and what has to fit together, as measured from the states that
/// a student's engine returns.

#include <optional>
#include <string>

#include "10_only_what_a_scene_needs/contract.hpp"
#include "judge/mine/own_engine.hpp"
#include "tumble/core/types.hpp"

namespace tumble::judge::mine {

struct ProblemResult;

/// By how much at most the states of a run break what has to stay, as fractions.
struct Invariants {
  double energy = 0, length = 0, momentum = 0;
};

/// How the orientation turns in the first thousandth of a second.
struct Turning {
  Vec3 omega;     ///< as it follows from L [rad/s]
  Vec3 measured;  ///< as q has turned [rad/s]
  Mat3 R;         ///< orientation meanwhile

  /// Whether q turns with ω.
  bool right() const { return (measured - omega).norm() <= 0.02 * omega.norm(); }
};

/// What 10.3 says of a run that is so coarse that the energy visibly strays.
struct DriftResult {
  std::optional<only_what_a_scene_needs::EnergyDrift> own;
  only_what_a_scene_needs::EnergyDrift right{};
  std::string failure;
};

/// Files laws and turning, by the best of the student's methods that run at all.
void look_at_invariants(const OwnEngine& engine, ProblemResult& result);

DriftResult drift_of(const OwnEngine& engine, const ProblemResult& result);

}  // namespace tumble::judge::mine
