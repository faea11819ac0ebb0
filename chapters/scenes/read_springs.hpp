#pragma once
/// @file
/// The springs of a scene file that join two bodies.

#include "scenes/scene.hpp"
#include "support/place.hpp"

namespace tumble::scenes {

/// @param springs the list in the file
/// @param bodies  of the scene, read already
/// @throws std::invalid_argument that says where in the file, and what: a body that is not there,
///         one that is held, a spring from a body to itself
std::vector<SpringBetween> read_springs(const support::Place& springs,
                                        const std::vector<SceneBody>& bodies);

}  // namespace tumble::scenes
