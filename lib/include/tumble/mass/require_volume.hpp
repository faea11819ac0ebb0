#pragma once
/// @file
/// What mass properties must be before they can be those of a body.

#include "tumble/core/require.hpp"
#include "tumble/mass/error_bound.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// Passes on mass properties that can be those of a body.
/// @throws std::invalid_argument if the mesh is inside out, or so flat, thin or small that no digit
///         of its mass is certain
inline BoundedMassProperties require_volume(const BoundedMassProperties& body) {
  require(body.mass_error_bound < 1,
          "the mesh encloses no volume that rounding leaves certain: mass ", body.mass,
          " kg, with a relative error of up to ", body.mass_error_bound);
  require(body.mass > 0,
          "the mesh is inside out: its faces go round clockwise seen from outside (mass ",
          body.mass, " kg)");
  require(body.inertia.trace() > 0 && body.inertia.allFinite(),
          "the inertia of the mesh is too small or too large for double");
  return body;
}

/// @}

}  // namespace tumble
