#pragma once
/// @file
/// What all parts of this chapter's program share: the bodies that tumble, and how they are set
/// spinning.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "objects/tumbling_bodies.hpp"
#include "support/plot.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/body.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/rotation.hpp"

namespace rigid_body_chapter {

using namespace tumble;
using namespace tumble::bodies;
using support::error_number;
using support::error_or_rounding;
using support::number;
using support::order_text;
using support::Table;
using support::Vec2;

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// ω along the axes of the least, middle and largest moment [rad/s].
inline Vec3 omega_principal(const RigidBody<>& body, const RigidBodyState<>& state) {
  const Derived<> now = derived(body, state);
  return principal_axes(body.I_body()).R.transpose() * (now.R.transpose() * now.omega);
}

}  // namespace rigid_body_chapter
