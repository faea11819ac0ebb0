#pragma once
/// @file
/// What simulate() is asked for.

#include <cmath>
#include <limits>
#include <vector>

#include "tumble/core/require.hpp"

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
inline void require_valid_task(const SimulationTask& task) {
  require(std::isfinite(task.t0) && std::isfinite(task.t1), "simulate: from t0 = ", task.t0,
          " to t1 = ", task.t1, " is not a span of time");
  require(task.tolerance > 0 && std::isfinite(task.tolerance), "simulate: the tolerance ",
          task.tolerance, " is not positive and finite");
  require(task.longest_step > 0, "simulate: longest_step = ", task.longest_step,
          " s is not positive");
  for (const double t : task.breaks)
    require(std::isfinite(t), "simulate: a break at t = ", t, " is not a time");
}

}  // namespace detail

}  // namespace tumble
