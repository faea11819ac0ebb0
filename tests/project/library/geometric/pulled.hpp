#pragma once
/// @file
/// A force on a point of a body, and where the body starts.

#include "tumble/body/forces.hpp"
#include "tumble/body/state.hpp"

namespace tumble::test {

inline const ForceAtBodyPoint pull{Vec3(0, 0, -5), Vec3(0.3, 0, 1)};

inline RigidBodyState<> start() {
  return {Vec3(0, 0, 1), Quat(1, 0, 0, 0), Vec3(1, 0, 0), Vec3(1, -2, 5)};
}

}  // namespace tumble::test
