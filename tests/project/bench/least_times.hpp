#pragma once
/// @file
/// How long each of several things takes, measured so that their ratios hold on a busy machine.

#include <functional>
#include <vector>

namespace tumble::bench {

/// Which time is measured: of a clock on the wall, or of the processor on the calling thread, which
/// a busy machine does not prolong.
enum class Clock { wall, thread };

/// Something to be timed.
struct Timed {
  std::function<double()> run;  ///< gives a number that depends on all that it computes; or none
  int repetitions;
  double seconds;  ///< of each repetition, at least: runs are repeated to fill it
  Clock clock = Clock::wall;
};

/// The least time of one run [s] over the repetitions of each, which take turns at random; ∞ where
/// there is nothing to run.
std::vector<double> least_times(const std::vector<Timed>& all);

}  // namespace tumble::bench
