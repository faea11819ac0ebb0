#pragma once

#include "tumble/mass/require_volume.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::detail {

TUMBLE_BODY void require_normal(const MassProperties& body, const char* of) {
  require(std::isnormal(body.mass), "the mass of the ", of, ", ", body.mass,
          " kg, is too small or too large for double");
  // Beside what is 2⁻¹⁰⁷⁴, the smallest double, a tensor keeps its digits only if it is much
  // larger.
  require(body.inertia.trace() > 0x1p-960 && body.inertia.allFinite() && body.centre.allFinite(),
          "the inertia of the ", of, " is too small or too large for double");
}

}  // namespace tumble::detail

namespace tumble {

TUMBLE_BODY BoundedMassProperties require_volume(const BoundedMassProperties& body) {
  require(body.mass_error_bound < 1, "rounding hides the volume of the mesh: mass ", body.mass,
          " kg, with a relative error of up to ", body.mass_error_bound);
  require(body.mass > 0,
          "the mesh is inside out: its faces go round clockwise seen from outside (mass ",
          body.mass, " kg). Reverse the corners of its faces");
  detail::require_normal(body, "mesh");
  require(std::isfinite(body.centre_error_bound),
          "the inertia of the mesh is too small or too large for double");
  require(body.inertia_error_bound < 1,
          "rounding hides the inertia of the mesh: a relative error of up to ",
          body.inertia_error_bound);
  return body;
}

}  // namespace tumble
