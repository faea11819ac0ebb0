#pragma once
/// @file
/// What simulate() is asked for.

#include <limits>
#include <vector>

namespace tumble {

/// @addtogroup simulate
/// @{

/// What a simulation is to give.
enum class Wanted {
  trajectory,  ///< everything
  path_only,   ///< x and P; q and L stay as they were at the start
};

/// What to simulate beside the body and its forces.
struct SimulationTask {
  double t0 = 0;            ///< [s]
  double t1 = 1;            ///< [s]; before t0 for the motion that led to the start
  double tolerance = 1e-6;  ///< of the orientation in radians, of all else relative to its size
  Wanted wanted = Wanted::trajectory;
  /// When forces begin, end or jump [s]: no step goes across. For forces of your own: jumps that
  /// are not told are found where they last for a two-thousandth of the span, and cost more.
  std::vector<double> breaks = {};
  /// No step is longer [s]. For forces of your own that act for a very short time.
  double longest_step = std::numeric_limits<double>::infinity();
};

/// @}

namespace detail {

/// @throws std::invalid_argument if the task means nothing
void require_valid_task(const SimulationTask& task);

}  // namespace detail

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/simulation_task.inl"
#endif
