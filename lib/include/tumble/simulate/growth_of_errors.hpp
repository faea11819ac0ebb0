#pragma once
/// @file
/// What a motion makes of small errors, remembered from one pair of runs to the next.

#include <algorithm>

#include "tumble/core/rounding.hpp"
#include "tumble/simulate/stated_error.hpp"

namespace tumble::detail {

/// What a motion makes of errors of one step, as rougher pairs of runs have shown. Near rounding
/// two runs are now and then close to each other by luck. With a larger tolerance they are not: the
/// rough run's error is most of what they differ by.
class GrowthOfErrors {
 public:
  void learn(const TwoRuns& runs) {
    constexpr double too_large = 0.05;  // is not proportional to anything
    if (runs.difference < too_large) growth_ = std::max(growth_, runs.difference / runs.epsilon);
  }

  /// What it makes of steps with this tolerance, or with what rounding makes of them.
  double of_least(double tolerance) const {
    return growth_ * std::max(tolerance, 4 * unit_roundoff);
  }

 private:
  double growth_ = 0;
};

}  // namespace tumble::detail
