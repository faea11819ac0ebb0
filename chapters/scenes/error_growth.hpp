#pragma once
/// @file
/// How much larger impacts make a small error of the start: the run again, from a start that is a
/// trifle different.

#include "scenes/motions.hpp"

namespace tumble::scenes {

/// Two runs side by side at the end of the shorter one.
struct ErrorGrowth {
  double start;     ///< of each body's speeds, that which the second run differs by at the start
  double distance;  ///< of the two places of a body's centre, at most [m]
  double angle;     ///< between the two orientations of a body, at most [rad]
};

ErrorGrowth error_growth(const Contacts& contacts);

}  // namespace tumble::scenes
