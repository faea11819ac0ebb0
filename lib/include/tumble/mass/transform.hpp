#pragma once
/// @file
/// Mass properties of a body that was turned, moved, stretched, or joined with another one.
///
/// I_world = R I_body Rᵀ. Source: e.g. Baraff, "Rigid Body Simulation I" (1997), §2.10; joining by
/// the parallel axis theorem.

#include <cmath>
#include <span>

#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"
#include "tumble/mass/mass_properties.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// R I Rᵀ: the inertia of a body turned by R, exactly symmetric [kg m²].
/// @param R rotation, body to world
/// @param I symmetric tensor in body axes [kg m²]
inline Mat3 rotate_inertia(const Mat3& R, const Mat3& I) {
  const Mat3 turned = R * I * R.transpose();
  return (turned + turned.transpose()) / 2;
}

/// The body turned about the origin of its coordinates: x → R x.
inline MassProperties rotated(const MassProperties& body, const Mat3& R) {
  return {body.mass, R * body.centre, rotate_inertia(R, body.inertia)};
}

/// The body moved: x → x + d [m].
inline MassProperties translated(const MassProperties& body, const Vec3& d) {
  return {body.mass, body.centre + d, body.inertia};
}

/// The body stretched along the axes at the same density: x → (s_x x, s_y y, s_z z).
/// @param s factors; a common factor gives mass s³ and inertia s⁵
/// @throws std::invalid_argument if a factor is not positive and finite
MassProperties scaled(const MassProperties& body, const Vec3& s);

/// The body enlarged s times in all directions at the same density.
/// @throws std::invalid_argument if s is not positive and finite
inline MassProperties scaled(const MassProperties& body, double s) {
  require(s > 0 && std::isfinite(s), "the scale factor ", s, " is not positive and finite");
  return {s * s * s * body.mass, s * body.centre, s * s * s * s * s * body.inertia};
}

/// Two bodies as one rigid body, both given in the same coordinates.
/// @throws std::invalid_argument if a mass is not positive and finite
MassProperties combine(const MassProperties& a, const MassProperties& b);

/// Any number of bodies as one rigid body, all given in the same coordinates.
/// @throws std::invalid_argument if there are none, or a mass is not positive and finite
MassProperties combine(std::span<const MassProperties> bodies);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/transform.inl"
#endif
