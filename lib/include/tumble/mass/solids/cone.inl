#pragma once

#include "tumble/mass/solids/cone.hpp"

#include <numbers>

#include "tumble/core/compiled.hpp"

namespace tumble {

TUMBLE_BODY MassProperties mass_properties(const Cone& cone, double density) {
  detail::require_positive(density, "the density");
  const Vec3 corner = cone.bounds().max();
  const double r2 = corner.x() * corner.x(), h = corner.z();
  const double mass = density * (std::numbers::pi * r2 * h / 3);
  const double across = 3 * mass * (4 * r2 + h * h) / 80;
  return detail::symmetric_body(mass, h / 4, across, across, 3 * mass * r2 / 10);
}

}  // namespace tumble
