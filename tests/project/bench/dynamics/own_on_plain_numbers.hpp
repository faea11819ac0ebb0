#pragma once
/// @file
/// The library's solvers on seven plain numbers, as the peers' solvers get them.

#include "project/bench/dynamics/contest.hpp"

namespace tumble::bench {

void add_own_on_plain_numbers(Contestants& contestants);

}  // namespace tumble::bench
