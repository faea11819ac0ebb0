#pragma once
/// @file
/// What the bodies do.

#include "project/bench/dynamics/contest.hpp"

namespace tumble::bench {

/// FREE (the separatrix problem), TOP (the Lagrange top) and HEAVY (no closed form).
std::vector<Problem> problems();

/// Free bodies with all sorts of moments, spinning at up to 5 rad/s, the same in every run.
Scene crowd(int bodies);

}  // namespace tumble::bench
