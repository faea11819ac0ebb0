#pragma once
/// @file
/// What of a scene is too fast to be followed.

#include <string>

#include "scenes/scene.hpp"

namespace tumble::scenes {

/// Which force on the body makes it move fastest, and how strong it could be; nothing where none is
/// so fast that it could be the reason why a run does not end.
std::string fastest_force(const SceneBody& body, double duration);

/// The same of all bodies that springs join, and of these springs.
std::string fastest_joined_force(const Scene& scene);

}  // namespace tumble::scenes
