#pragma once
/// @file
/// A plank that is kicked, and that hangs on a rope.

#include "common.hpp"

namespace momentum_chapter {

constexpr double plank_length = 1, plank_mass = 2;  // [m], [kg]

/// A thin plank along x.
inline RigidBody<> plank() {
  const double width = 0.1, thickness = 0.02, m = plank_mass / 12;
  const Vec3 square(plank_length * plank_length, width * width, thickness * thickness);
  const Vec3 moments = m * (Vec3::Constant(square.sum()) - square);
  return {plank_mass, moments.asDiagonal()};
}

}  // namespace momentum_chapter
