#pragma once
/// @file
/// Bodies that springs join move together.

#include <vector>

#include "scenes/scene.hpp"

namespace tumble::scenes {

/// Which bodies have a spring to another one, by their numbers, ascending.
std::vector<std::size_t> joined_bodies(const Scene& scene);

/// Their trajectories, in that order; each report is that of all of them.
/// @throws std::runtime_error if the motion cannot be followed to its end
std::vector<Trajectory> move_joined(const Scene& scene, const std::vector<std::size_t>& joined);

}  // namespace tumble::scenes
