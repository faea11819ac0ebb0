#pragma once
/// @file
/// Many free bodies in one call, a second in steps of 1/240 s.

#include "project/bench/dynamics/contest.hpp"
#include "support/table.hpp"

namespace tumble::bench {

struct ManyBodies {
  support::Table table;
  std::string broken;  ///< which of ours err more than we promise; empty if none does
};

/// For each stepper the time of a step of one body, the root mean square of the orientation errors
/// after a second, and how many times as long it takes as ours that is fastest.
ManyBodies many_bodies(int bodies, const std::vector<Stepper>& steppers, const Budget& budget);

}  // namespace tumble::bench
