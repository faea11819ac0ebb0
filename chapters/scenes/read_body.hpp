#pragma once
/// @file
/// One body of a scene file.

#include "scenes/scene.hpp"
#include "support/place.hpp"

namespace tumble::scenes {

/// What is the same for all bodies of a scene.
struct Surroundings {
  std::filesystem::path folder;  ///< of the scene file
  Vec3 gravity;                  ///< [m/s²]
  bool contact;                  ///< whether bodies can hit things: then they need a shape
};

/// @param index from 0, for its name if it has none
/// @throws std::invalid_argument that says where in the file, and what
SceneBody read_body(const support::Place& place, std::size_t index, const Surroundings& around);

}  // namespace tumble::scenes
