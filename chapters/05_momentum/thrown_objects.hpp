#pragma once
/// @file
/// The objects of daily life, what they weigh and how they are called.

#include <array>

#include "common.hpp"
#include "objects/objects.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"

namespace momentum_chapter {

inline MassProperties properties_of(const objects::Object& object) {
  return mesh_mass_properties(object.mesh(object.for_drawings), object.density);
}

inline const objects::Object& free_handle = objects::all[0];
inline const objects::Object& racket = objects::all[2];

/// The names of the objects, as one says them.
inline constexpr std::array object_names{"T-handle", "wing nut", "tennis racket", "mug", "gear"};

}  // namespace momentum_chapter
