#pragma once
/// @file
/// A scene file's bodies and walls as the library's.

#include "scenes/scene.hpp"
#include "tumble/contact/scene.hpp"

namespace tumble::scenes {

/// @param scene with contact
contact::ContactScene contact_scene(const Scene& scene);

/// How near bodies are when they touch [m]: the scene's tolerance as a part of the smallest body.
double contact_tolerance(const Scene& scene);

}  // namespace tumble::scenes
