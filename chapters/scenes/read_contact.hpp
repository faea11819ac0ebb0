#pragma once
/// @file
/// What bodies of a scene file can hit, and how they come off.

#include "scenes/scene.hpp"
#include "support/place.hpp"

namespace tumble::scenes {

/// Floor, walls, restitution and friction; nothing if none of them is there.
/// @throws std::invalid_argument that says where in the file, and what
std::optional<SceneContact> read_contact(const support::Place& root);

/// @throws std::invalid_argument if a body overlaps a wall or another body at the start: who, and
///         by how much
void require_apart(const support::Place& root, const Scene& scene);

}  // namespace tumble::scenes
