#pragma once
/// @file
/// The motion under steady forces: in closed form where there is one, else by Taylor series.

#include <concepts>

#include "tumble/body/steady_forces.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// @tparam Forces SteadyForces: so that, where all is in headers, only programs that have some pay
///         for compiling the series
template <std::same_as<SteadyForces> Forces>
Trajectory steady_trajectory(const RigidBody<>& body, const RigidBodyState<>& start,
                             const Forces& forces, const SimulationTask& task);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/steady_trajectory.inl"
#endif
