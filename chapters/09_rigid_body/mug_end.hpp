#pragma once
/// @file
/// Where the mug on its spring is half a second after the start.

#include "common.hpp"
#include "objects/hanging_mug.hpp"

namespace rigid_body_chapter {

constexpr double mug_time = 0.5;  // [s]

inline const RigidBodyState<>& mug_end() {
  static const RigidBodyState<> end = followed(hanging_mug(), mug_start(), mug_time);
  return end;
}

}  // namespace rigid_body_chapter
