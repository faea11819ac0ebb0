#pragma once
/// @file
/// FREE in very many steps of one length, as a game or a robot simulator takes them.

#include "project/bench/dynamics/contest.hpp"
#include "support/table.hpp"

namespace tumble::bench {

struct LongRun {
  support::Table table;
  std::string broken;  ///< what of ours drifted more than we promise; empty if nothing did
};

/// For each stepper the largest relative error of energy and of angular momentum, or the step at
/// which it blows up, with steps of 1/60 s and of 1/240 s.
LongRun long_run(const Problem& free, const std::vector<Stepper>& steppers, int steps);

}  // namespace tumble::bench
