#pragma once

#include "tumble/mass/solids/cylinder.hpp"

#include <numbers>

#include "tumble/core/compiled.hpp"

namespace tumble {

TUMBLE_BODY MassProperties mass_properties(const Cylinder& cylinder, double density) {
  detail::require_positive(density, "the density");
  const Vec3 corner = cylinder.bounds().max();
  const double r2 = corner.x() * corner.x(), h = 2 * corner.z();
  const double mass = density * (std::numbers::pi * r2 * h);
  const double across = mass * (3 * r2 + h * h) / 12;
  return detail::symmetric_body(mass, 0, across, across, mass * r2 / 2);
}

}  // namespace tumble
