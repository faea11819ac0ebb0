#pragma once
/// @file
/// Where a problem's motion ends.

#include "judge/mine/problem.hpp"

namespace tumble::judge::mine {

/// The orientation at the end, to rounding: the best method, in long double where that is more than
/// double, at the tightest tolerance.
Quat true_end(const Problem& problem);

}  // namespace tumble::judge::mine
