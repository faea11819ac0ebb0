#pragma once

#include "tumble/mass/solids/ellipsoid.hpp"

#include <numbers>

#include "tumble/core/compiled.hpp"

namespace tumble {

TUMBLE_BODY MassProperties mass_properties(const Ellipsoid& ellipsoid, double density) {
  detail::require_positive(density, "the density");
  const Vec3 squares = ellipsoid.bounds().max().cwiseAbs2();
  const double mass = density * (4 * std::numbers::pi / 3 * ellipsoid.radii.prod());
  return detail::symmetric_body(mass, 0, mass * (squares.y() + squares.z()) / 5,
                                mass * (squares.z() + squares.x()) / 5,
                                mass * (squares.x() + squares.y()) / 5);
}

}  // namespace tumble
