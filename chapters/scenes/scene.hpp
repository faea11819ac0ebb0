#pragma once
/// @file
/// What a scene file says: bodies, what pushes them, for how long and how exactly.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tumble/simulate/held.hpp"

namespace tumble::scenes {

/// A body as it starts, and what pushes it.
struct SceneBody {
  std::string name;
  RigidBody<> body;
  RigidBodyState<> start;
  SteadyForces steady;
  std::vector<SpringToWorld> springs;
  std::optional<HeldBody> held = {};  ///< if a point of it stays where it is
};

/// When to stop: a coordinate of one body passes a level.
struct StopWhen {
  std::size_t body;  ///< which of the bodies
  int coordinate;    ///< 0, 1, 2 for x, y, z
  double level;      ///< [m]
};

struct Scene {
  std::vector<SceneBody> bodies;
  SimulationTask task;
  double every = 0;  ///< between two records [s]; 0: only the end is asked for
  std::optional<StopWhen> stop;
};

/// Reads a scene; files that it names are looked for beside it.
/// @throws std::invalid_argument that says where in the file, and what
Scene read_scene(const std::filesystem::path& file);

}  // namespace tumble::scenes
