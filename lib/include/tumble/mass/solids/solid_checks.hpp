#pragma once
/// @file
/// What the closed forms ask of their dimensions and densities.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/mass/mass_properties.hpp"

namespace tumble::detail {

/// Refuses a length, density or the like that is not positive and finite.
/// @param what its name, for the message: "the cylinder's radius"
/// @throws std::invalid_argument with the name and the value
inline void require_positive(double value, const char* what) {
  require(value > 0 && std::isfinite(value), what, " is ", value, ", not positive and finite");
}

/// Mass properties of a body that is symmetric about the coordinate planes x = 0 and y = 0.
/// @param z height of the centre of mass [m]
inline MassProperties symmetric_body(double mass, double z, double Ixx, double Iyy, double Izz) {
  return {mass, Vec3(0, 0, z), Vec3(Ixx, Iyy, Izz).asDiagonal()};
}

}  // namespace tumble::detail
