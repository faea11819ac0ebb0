#pragma once
/// @file
/// FREE in very many steps of one length, as a game or a robot simulator takes them.

#include "bench/dynamics/contest.hpp"
#include "support/table.hpp"

namespace tumble::bench {

/// For each stepper the largest relative error of energy and of angular momentum, or the step at
/// which it blows up, with steps of 1/60 s and of 1/240 s.
support::Table long_run(const Problem& free, const std::vector<Stepper>& steppers, int steps);

}  // namespace tumble::bench
