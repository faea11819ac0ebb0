#pragma once
/// @file
/// What all parts of this chapter's program share: how errors are written, and energies.

#include <cmath>
#include <string>
#include <vector>

#include "known_turning.hpp"
#include "objects/hanging_mug.hpp"
#include "support/plot.hpp"
#include "support/sketch.hpp"
#include "support/sphere_curves.hpp"
#include "support/table.hpp"
#include "tumble/geometric.hpp"
#include "tumble/rotation.hpp"
#include "tumble/simulate.hpp"
#include "tumble/steady.hpp"

namespace scene_chapter {

using namespace tumble::bodies;
using support::degrees, support::error_number, support::error_or_rounding, support::number;
using support::order_text, support::sphere_view, support::visible;
using support::Table, support::Vec2, support::Way;

// ── Numbers ──

/// An error that may be rounding: the power of ten that it is below, twice as large or not.
inline std::string below(double error) {
  return "< 1e" + std::to_string(static_cast<int>(std::floor(std::log10(2 * error))) + 1);
}

/// An error, or that it is below what the truth is known to.
inline std::string error_above(double error, double known) {
  return error < known ? "< " + number(known) : error_number(error);
}

// ── Scenes ──

/// Kinetic energy and, of the weight at a point, the potential [J].
inline double whole_energy(const KnownTurning& scene, const RigidBodyState<>& state) {
  double energy = kinetic_energy(scene.body, state);
  for (const SteadyForces::AtPoint& f : scene.forces.at_point)
    energy -= f.force.dot(to_matrix(state.q) * f.p_body);
  return energy;
}

}  // namespace scene_chapter
