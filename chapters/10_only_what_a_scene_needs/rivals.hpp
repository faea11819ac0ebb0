#pragma once
/// @file
/// The methods that take equal steps through the same scene.

#include <functional>
#include <string>
#include <vector>

#include "10_only_what_a_scene_needs/known_turning.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/geometric/lie_group_rk4.hpp"
#include "tumble/geometric/splitting.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/rk4.hpp"

namespace scene_chapter {

using HeldRhs = RigidBodyRhs<double, SteadyForces>;

/// One step of some method: (t, state, h) → state.
using Stepping = std::function<RigidBodyState<>(double, const RigidBodyState<>&, double)>;

/// A method and how often it asks for the forces in a step.
struct Steps {
  std::string name;
  int evaluations;
  Stepping step;
};

template <class Method>
Steps of_method(const KnownTurning& scene, const std::string& name, int evaluations) {
  const HeldRhs motion(scene.body, scene.forces);
  return {name, evaluations, [motion](double t, const RigidBodyState<>& state, double h) {
            return unpack<double>(PackedState<double>(Method::step(motion, t, pack(state), h)));
          }};
}

template <class Scheme>
Steps of_splitting(const KnownTurning& scene, const std::string& name) {
  const HeldRhs motion(scene.body, scene.forces);
  const geometric::Splitting<Scheme, SteadyForces> splitting(motion);
  constexpr int parts = static_cast<int>(Scheme::composition.parts.size());
  // A kick that ends a step and the one that begins the next are at the same place.
  return {name, parts / 2, [splitting](double t, const RigidBodyState<>& state, double h) {
            return splitting.step(t, state, h);
          }};
}

inline Steps of_turns(const KnownTurning& scene) {
  const HeldRhs motion(scene.body, scene.forces);
  return {"Lie-group RK4", 4, [motion](double t, const RigidBodyState<>& state, double h) {
            return geometric::LieGroupRk4::step(motion, t, state, h);
          }};
}

inline std::vector<Steps> rivals(const KnownTurning& scene) {
  return {of_method<Rk4>(scene, "RK4", 4),
          of_turns(scene),
          of_method<Dop853>(scene, "DOP853, fixed", 12),
          of_splitting<geometric::Strang>(scene, "splitting, order 2"),
          of_splitting<geometric::BlanesMoan4>(scene, "splitting, order 4"),
          of_splitting<geometric::BlanesMoan6>(scene, "splitting, order 6"),
          of_splitting<geometric::KahanLi8>(scene, "splitting, order 8")};
}

}  // namespace scene_chapter
