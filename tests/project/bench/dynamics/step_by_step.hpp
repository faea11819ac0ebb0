#pragma once
/// @file
/// An ensemble that takes one step a call, as a loop does that looks at its bodies in between: then
/// memory is read and written at each step.

#include "project/bench/dynamics/contest.hpp"
#include "support/table.hpp"

namespace tumble::bench {

/// For ensembles up to `most` bodies the time of a step of one body, by one step a call and by a
/// hundred.
support::Table step_by_step(std::size_t most, const Budget& budget);

}  // namespace tumble::bench
