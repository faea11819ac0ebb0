#pragma once
/// @file
/// An error that is kept over the whole span, not step by step: a motion is computed twice, with
/// rough and with fine steps.
///
/// What the two differ by, d, is the rough run's error: its tolerance ε times what the motion makes
/// of errors. So the fine run, with a smaller tolerance, has an error of a share of d, and its
/// rounding makes one of about d u/ε for each step. If that is not good enough, both are run again
/// with an ε that is. How far proportion can be trusted, a run says: see KnowsItsErrors.
///
/// The rough run starts a little beside the start: what the motion makes of that is in d too.
///
/// Source: Shampine, "Error estimation and control for ODEs", J. Sci. Comput. 25 (2005), §5, on
/// tolerance proportionality and global errors.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

#include "tumble/body/state.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// What becomes of zeros in q and L. They stay where nothing rounds them: then a motion about one
/// axis stays one. Where the state is turned into other axes, rounding makes numbers of them.
enum class Zeros { stay, move };

/// A start beside the start. Each number of x and P moves by up to a part of itself, each of q and
/// L by one of the whole: turning mixes them, so what rounding makes of the large ones is in the
/// small ones.
RigidBodyState<> beside(const RigidBodyState<>& start, double part, Zeros zeros = Zeros::stay);
inline std::vector<RigidBodyState<>> beside(std::vector<RigidBodyState<>> starts, double part) {
  for (RigidBodyState<>& start : starts) start = beside(start, part);
  return starts;
}

/// Two runs, and what they differ by.
struct TwoRuns {
  double difference;  ///< at most, on the way
  double of_small;    ///< the same, a part of sizes that are too small to matter; 0 without such
  double epsilon;     ///< the rough one's tolerance of a step
  double tolerance;   ///< the fine one's
  int steps;          ///< the fine one's
  double radians;     ///< by which the body turns
};

/// What the rounding of the fine run's steps comes to, if nothing makes it grow.
inline double rounding_of(const TwoRuns& runs) {
  return std::sqrt(static_cast<double>(runs.steps)) * unit_roundoff;
}

/// How far what two runs differ by tells their errors.
template <class Run>
concept KnowsItsErrors = requires {
  /// The error of a step may be so many times smaller than its tolerance.
  { Run::margin } -> std::convertible_to<double>;
  /// The fine run's error may be so many times larger than in proportion to its tolerance.
  { Run::careful } -> std::convertible_to<double>;
};

/// What part of the difference is the fine run's error.
template <KnowsItsErrors Run>
double fine_share(const TwoRuns& runs) {
  // What differs by so much is not proportional to anything.
  constexpr double too_large = 0.05;
  if (!(runs.difference < too_large)) return 1;
  constexpr double of_start = 4;  // turned into other axes, which is in both runs alike
  const double rounding = of_start * unit_roundoff + rounding_of(runs);
  return std::min(
      1.0, Run::careful * (runs.tolerance / runs.epsilon) + Run::margin * rounding / runs.epsilon);
}

/// The error of the fine run.
/// @param lost what the moments have lost, see rounding_of_moments()
template <KnowsItsErrors Run>
double stated_error(const TwoRuns& runs, double lost) {
  const double growth = Run::margin * runs.difference / runs.epsilon;  // of a small error
  constexpr double everything = 4;
  return fine_share<Run>(runs) * runs.difference +
         std::min(everything, lost * (runs.radians + growth)) + 2 * unit_roundoff;
}

/// Writes into the report what error the fine run has.
/// @param unseen what both runs have not seen
template <KnowsItsErrors Run>
void state_errors(SimulationReport& report, const TwoRuns& runs, double lost, double unseen = 0) {
  report.error_estimate = unseen + stated_error<Run>(runs, lost);
  TwoRuns own = runs;
  own.difference = runs.of_small;
  const bool tells_more = !(runs.of_small <= runs.difference);
  report.error_of_small_motion = tells_more ? unseen + stated_error<Run>(own, lost) : 0;
}

/// What is stated where forces jump or bend. What a step makes of a jump depends on where in it the
/// jump is: by luck two runs are now and then ten times as close to each other as to the truth. On
/// random scenes four times what they differ by is enough in 98 of 100, and the tolerance is kept
/// all the same.
inline double error_beside_jumps(double error, double asked) {
  constexpr double luck = 4;
  return error <= asked ? std::min(luck * error, asked) : luck * error;
}

/// The ε to try next: what the error says is needed, but by at most 1000 at a time: a large error
/// says little.
inline double next_epsilon(double epsilon, double asked, double error, double lowest) {
  const double needed = epsilon * asked / (2 * error);
  return std::max(lowest, std::clamp(needed, epsilon / 1000, epsilon / 3));
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/stated_error.inl"
#endif
