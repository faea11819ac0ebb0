#pragma once
/// @file
/// What simulate() is asked for.

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
  double t1 = 1;            ///< [s], not before t0
  double tolerance = 1e-6;  ///< of the orientation in radians, of all else relative to its size
  Wanted wanted = Wanted::trajectory;
};

/// @}

}  // namespace tumble
