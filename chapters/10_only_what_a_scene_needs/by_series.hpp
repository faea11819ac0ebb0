#pragma once
/// @file
/// Steady forces by Taylor series.

#include "10_only_what_a_scene_needs/known_turning.hpp"
#include "tumble/steady/turning_by_series.hpp"

namespace scene_chapter {

inline Quat by_series(const KnownTurning& scene, double tolerance, int& order, int& steps) {
  const steady::SteadyTorque torque(scene.body, scene.forces);
  const steady::TurningBySeries<1> turning(torque, torque.turning(scene.start.q, scene.start.L), 0,
                                           scene.duration, tolerance);
  order = turning.order();
  steps = turning.steps();
  return torque.orientation(turning.end());
}

}  // namespace scene_chapter
