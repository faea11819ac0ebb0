#pragma once
/// @file
/// What all parts of this chapter's program share: the mug and its truth, and how numbers are
/// written.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "objects/objects.hpp"
#include "placed_mug.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/mass.hpp"
#include "tumble/mesh.hpp"
#include "tumble/rotation.hpp"

namespace point_sampling_chapter {

using namespace tumble;
using support::error_number;
using support::number;
using support::Table;
using support::Vec2;

inline const MeshSolid& mug_solid() {
  static const MeshSolid solid(mug());
  return solid;
}
/// To the last digit, by the method of chapter 8.
inline const MassProperties& mug_truth() {
  static const MassProperties truth = mesh_mass_properties(mug(), mug_density);
  return truth;
}

/// 12.3 %
inline std::string percent(double share, int digits = 2) {
  return number(100 * share, digits) + " %";
}

}  // namespace point_sampling_chapter
