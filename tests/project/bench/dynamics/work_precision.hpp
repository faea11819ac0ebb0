#pragma once
/// @file
/// Time against error of methods on one problem.

#include <vector>

#include "project/bench/dynamics/contest.hpp"

namespace tumble::bench {

/// How a stepper goes from a problem's start to its end.
Method as_method(const Stepper& stepper);

/// A curve for each method that is meant for the problem; errors are angles between computed and
/// true orientation at the end [rad].
std::vector<Curve> work_precision(const Problem& problem, const std::vector<Method>& methods,
                                  const Budget& budget);

}  // namespace tumble::bench
