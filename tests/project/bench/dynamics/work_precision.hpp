#pragma once
/// @file
/// Time against error of methods on one problem.

#include <vector>

#include "project/bench/dynamics/contest.hpp"

namespace tumble::bench {

/// How much time may be spent.
struct Budget {
  double longest_run;        ///< [s]: settings that take longer are not tried
  double longest_of_others;  ///< the same for other software, which has nothing to prove
  int repetitions;
  double seconds;  ///< of each repetition, at least
};

/// A setting of a method.
struct Point {
  double error;    ///< angle between computed and true orientation at the end [rad]
  double seconds;  ///< the least of all repetitions
};

/// The settings of a method that are more exact than all coarser ones.
struct Curve {
  const Method* method;
  std::vector<Point> points = {};

  double best_error() const;                    ///< [rad], ∞ if there is no point
  double seconds_to_reach(double error) const;  ///< the least, ∞ if no point is so exact
};

/// The errors that times are told for.
inline constexpr double marks[] = {1e-3, 1e-6, 1e-9, 1e-12};

/// How a stepper goes from a problem's start to its end.
Method as_method(const Stepper& stepper);

/// A curve for each method that is meant for the problem.
std::vector<Curve> work_precision(const Problem& problem, const std::vector<Method>& methods,
                                  const Budget& budget);

/// Whether each of ours came as close to the truth as it promises.
/// @throws std::invalid_argument that names those that did not
void check_promises(const Problem& problem, const std::vector<Curve>& curves);

}  // namespace tumble::bench
