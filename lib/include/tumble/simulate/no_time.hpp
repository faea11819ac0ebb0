#pragma once
/// @file
/// A span of no length.

#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// What has no time to move.
Trajectory no_time_trajectory(const RigidBody<>& body, const RigidBodyState<>& start,
                              const SimulationTask& task);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/no_time.inl"
#endif
