#pragma once
/// @file
/// How much larger impacts make a small error of the start: the run again, from a start that is a
/// trifle different.

#include <optional>
#include <vector>

#include "scenes/motions.hpp"

namespace tumble::scenes {

/// What became of the error of one body. Two motions are apart by the distance of the centres, and
/// by the angle between the orientations times the reach of the body.
struct BodyGrowth {
  int bounces;                   ///< impacts that count: no hops, and those at one time as one
  std::optional<double> factor;  ///< of the error, per bounce; none if it cannot be fitted
  /// When the two motions are farther apart than the body reaches [s], as the run counts it.
  std::optional<double> means_nothing_after;
};

/// Two runs side by side.
struct ErrorGrowth {
  double start;     ///< of each body's speeds, that which the second run differs by at the start
  double distance;  ///< at the end of the shorter run, of the two places of a body, at most [m]
  double angle;     ///< then, between the two orientations of a body, at most [rad]
  std::vector<BodyGrowth> bodies;
};

ErrorGrowth error_growth(const Contacts& contacts);

}  // namespace tumble::scenes
